#pragma once

#include "raylab/accelerator/bvh8/bvh8_split.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace raylab::bvh8_parts {

/// The top of a binary tree: every part of more than `size` references (eight or more) is split, level by level, by all
/// threads. Which of its nodes become wide ones is decided afterwards, so that no split of a large part waits for that.
class BinaryTop {
public:
    BinaryTop(References& references, std::size_t size, ThreadPool& threads);

    struct Part {
        ReferenceRange range;
        std::size_t left = 0;  // where its left half is among all, and the right one after it; 0: it was not split
    };
    /// All in one part, or the walls of a room and the rest.
    std::vector<Part> roots() const { return {parts_.begin(), parts_.begin() + roots_}; }
    /// A smaller part is split now, by the calling thread; ask once for each. `depth` is that of a wide node.
    std::pair<Part, Part> halves(const Part& part, int depth) const;

private:
    std::vector<References::Sides> split(const std::vector<std::size_t>& level, int depth, ThreadPool& threads) const;

    References& references_;
    std::vector<Part> parts_;
    std::ptrdiff_t roots_ = 0;
};

}  // namespace raylab::bvh8_parts
