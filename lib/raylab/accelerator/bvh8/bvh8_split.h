#pragma once

#include "raylab/accelerator/bvh8/bvh8_build.h"
#include "raylab/accelerator/bvh8/bvh8_parts.h"
#include "raylab/accelerator/bvh8/bvh8_plane_split.h"
#include "raylab/accelerator/bvh8/triangle_runs.h"
#include "raylab/base/large_pages.h"
#include "raylab/base/thread_pool.h"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace raylab::bvh8_parts {

/// The primitives, sorted into the parts of a tree. Several threads may split different parts at once, or share the
/// pieces of one: these depend on its size alone, so that the order of the references does not depend on the number of
/// threads.
class References {
public:
    References(const TriangleRuns& triangles, std::span<const Box> others, const Bvh8BuildOptions& options,
               ThreadPool& threads);

    const ReferenceRange& all() const { return root_; }
    /// The bounds of the corners of all triangles.
    const Extent& corners() const { return corners_; }
    /// The parts from which the tree is grown: all in one, or the walls of a room and the rest.
    std::vector<ReferenceRange> parts_of_root(ThreadPool& threads);
    std::span<const Reference> of(const ReferenceRange& part) const { return {all_.data() + part.begin, part.size()}; }

    /// Frees the references; nothing is asked of them any more.
    void release() { all_ = LargeArray<Reference>(); }

    /// Whether a part is one primitive, or so few triangles that they are tested at once; of walls those in one box.
    bool fit_in_leaf(const ReferenceRange& part) const;

    using Sides = std::pair<ReferenceRange, ReferenceRange>;

    /// Sorts a part so that both sides together have the lowest expected cost. Beyond a certain depth it is simply
    /// halved, so that the depth is bounded.
    Sides split(const ReferenceRange& part, int depth, ThreadPool& threads);

    /// How many references a thread gets at a time: an eighth of all, so that threads share the work on a small tree
    /// evenly. Less than 2048 are not worth a round of threads, and more than 16384 do not stay in a core's cache.
    std::size_t piece_size() const { return piece_size_; }
    static constexpr std::size_t min_piece_size = 2048;

private:
    enum class Side { left, right };
    struct SortedPiece;

    template <class Result, class Work>
    Result in_pieces(const ReferenceRange& part, ThreadPool& threads, const Work& work) const;
    ReferenceRange part_of(std::size_t begin, std::size_t end) const;
    Sides halves(const ReferenceRange& part);
    PlaneSplit best_plane(const ReferenceRange& part, const PlaneBinning& binning, ThreadPool& threads) const;
    Sides split_by_plane(const ReferenceRange& part, const PlaneBinning& binning, const PlaneSplit& plane,
                         ThreadPool& threads);
    template <class SideOf>
    Sides partition(const ReferenceRange& part, ThreadPool& threads, const SideOf& side_of);
    template <class SideOf>
    SortedPiece sort_piece(std::size_t begin, std::size_t end, const SideOf& side_of);
    void exchange(std::span<const SortedPiece> pieces, std::size_t middle, ThreadPool& threads);
    Sides with_room(Sides sides, std::size_t room);
    std::optional<Triangle> triangle_of(const Reference& one) const {
        return one.is_triangle() ? std::optional(triangles_[one.number()]) : std::nullopt;
    }

    const TriangleRuns& triangles_;
    std::size_t piece_size_;
    LargeArray<Reference> all_;
    ReferenceRange root_;
    Extent corners_;
    std::size_t walls_ = 0;  // so many of the first references
    float min_overlap_;
};

}  // namespace raylab::bvh8_parts
