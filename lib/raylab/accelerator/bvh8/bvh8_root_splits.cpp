#include "raylab/accelerator/bvh8/bvh8_root_splits.h"

#include "raylab/base/tiles.h"

#include <algorithm>
#include <array>

namespace raylab::bvh8_parts {

namespace {

constexpr int root_depth = 1;

// With one piece a thread alone splits all; with more than these, all threads are busy with each split long enough.
constexpr std::size_t most = 16 * References::piece_size;

}  // namespace

RootSplits::RootSplits(References& references, std::span<const ReferenceRange> parts_of_root, int threads)
    : references_(references) {
    const ReferenceRange& root = parts_of_root[0];
    const bool pays = threads > 1 && root.size() > References::piece_size && root.size() <= most;
    // (Where splits may cut triangles, a second one would cut them again.)
    if (!pays || parts_of_root.size() > 1 || root.room > 0) return;
    const References::Sides halves = references_.split(root, root_depth, threads);
    known_ = {{root, halves}};
    split_halves(halves, threads);
}

void RootSplits::split_halves(const References::Sides& halves, int threads) {
    std::array<std::vector<Known>, 2> found;
    for_each_piece(2, 1, threads, [&](std::size_t i, std::size_t) {
        const auto split = [&](const ReferenceRange& part) {
            const References::Sides sides = references_.split(part, root_depth, 1);
            found[i].push_back({part, sides});
            return sides;
        };
        const ReferenceRange& half = i == 0 ? halves.first : halves.second;
        if (references_.fit_in_leaf(half)) return;
        const auto [left, right] = split(half);
        if (!references_.fit_in_leaf(left)) split(left);
        if (!references_.fit_in_leaf(right)) split(right);
    });
    for (const auto& of_half : found) known_.insert(known_.end(), of_half.begin(), of_half.end());
}

References::Sides RootSplits::split(const ReferenceRange& part, int depth, int threads) {
    const auto is_it = [&](const Known& one) { return one.part.begin == part.begin && one.part.end == part.end; };
    const auto known = std::ranges::find_if(known_, is_it);
    return known != known_.end() ? known->sides : references_.split(part, depth, threads);
}

}  // namespace raylab::bvh8_parts
