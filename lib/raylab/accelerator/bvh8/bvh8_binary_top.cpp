#include "raylab/accelerator/bvh8/bvh8_binary_top.h"

#include <algorithm>
#include <functional>

namespace raylab::bvh8_parts {

BinaryTop::BinaryTop(References& references, std::size_t size, ThreadPool& threads) : references_(references) {
    std::vector<std::size_t> level;  // which are to be split next
    const auto add = [&](const ReferenceRange& part) {
        if (part.size() > size) level.push_back(parts_.size());
        parts_.push_back({part});
    };
    std::ranges::for_each(references_.parts_of_root(threads), add);
    roots_ = std::ssize(parts_);
    for (int depth = 1; !level.empty(); ++depth) {
        // The largest first, so that the threads are done at the same time.
        std::ranges::sort(level, std::greater(), [&](std::size_t i) { return parts_[i].range.size(); });
        const std::vector<References::Sides> sides = split(level, depth, threads);
        for (std::size_t i = 0; i < level.size(); ++i) parts_[level[i]].left = parts_.size() + 2 * i;
        level.clear();
        for (const auto& [left, right] : sides) {
            add(left);
            add(right);
        }
    }
}

// Many parts are split by one thread each, few by all threads, one after the other.
std::vector<References::Sides> BinaryTop::split(const std::vector<std::size_t>& level, int depth,
                                                ThreadPool& threads) const {
    const bool many = level.size() >= 2 * static_cast<std::size_t>(threads.size());
    ThreadPool alone;
    ThreadPool& for_level = many ? threads : alone;
    ThreadPool& for_part = many ? alone : threads;
    std::vector<References::Sides> sides(level.size());
    for_level.for_each_in_turn(
        level.size(), [&](std::size_t i) { sides[i] = references_.split(parts_[level[i]].range, depth, for_part); });
    return sides;
}

std::pair<BinaryTop::Part, BinaryTop::Part> BinaryTop::halves(const Part& part, int depth) const {
    if (part.left != 0) return {parts_[part.left], parts_[part.left + 1]};
    ThreadPool alone;
    const auto [left, right] = references_.split(part.range, depth, alone);
    return {{left}, {right}};
}

}  // namespace raylab::bvh8_parts
