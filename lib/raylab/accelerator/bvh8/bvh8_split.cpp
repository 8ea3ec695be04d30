#include "raylab/accelerator/bvh8/bvh8_split.h"

#include "raylab/accelerator/bvh8/bvh8_walls.h"

#include <algorithm>
#include <array>

namespace raylab::bvh8_parts {

namespace {

// The boxes and counts of the primitives in the bins of each axis.
class Bins {
public:
    explicit Bins(int count = 0) : count_(count) {
        for (auto& axis : bins_) std::fill_n(axis.begin(), count, Bin{});
    }

    // (Unrolled, the loop takes each bin from where the vector is. Otherwise GCC stores it, and reads one number after
    // the other: a fifth of a tree's time.)
    void add(const Reference& one, FourInts bin) {
#pragma GCC unroll 3
        for (int axis = 0; axis < 3; ++axis) {
            Bin& into = bins_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(bin[axis])];
            into.box.add(one.box());
            ++into.count;
        }
    }
    void add(const Bins& other) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) bins_[axis][i].add(other.bins_[axis][i]);
    }

    // Replaces `best` by the split with the lowest cost between two bins of an axis, if that is lower.
    void try_axis(int axis, Split& best) const {
        const auto& bins = bins_[static_cast<std::size_t>(axis)];
        std::array<float, max_bins> right_work;  // of the bins from here on
        Bin right;
        for (int i = count_; i-- > 1;) {
            right.add(bins[static_cast<std::size_t>(i)]);
            right_work[static_cast<std::size_t>(i)] = right.count == 0 ? infinity : right.work();
        }
        Bin left;
        for (int i = 1; i < count_; ++i) {
            left.add(bins[static_cast<std::size_t>(i) - 1]);
            if (left.count == 0) continue;
            const float cost = left.work() + right_work[static_cast<std::size_t>(i)];
            if (cost < best.cost) best = {axis, i, cost};
        }
    }

    // Half the surface area of what the boxes on both sides of a split have in common.
    float overlap(const Split& split) const {
        Extent left, right;
        for (int i = 0; i < count_; ++i)
            (i < split.bin ? left : right)
                .add(bins_[static_cast<std::size_t>(split.axis)][static_cast<std::size_t>(i)].box);
        const Extent both{larger(left.min, right.min), smaller(left.max, right.max)};
        for (int axis = 0; axis < 3; ++axis)
            if (both.min[axis] > both.max[axis]) return 0;
        return both.half_area();
    }

private:
    int count_;
    std::array<std::array<Bin, max_bins>, 3> bins_;
};

// From this depth on parts are halved, so that the depth is bounded.
constexpr int halving_depth = Bvh8Nodes::max_depth - 30;

// The overlap of two parts from which on planes are tried, in surface areas of the whole.
constexpr float least_overlap = 1e-4f;

bool is_same(const Extent& a, const Extent& b) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.min[axis] != b.min[axis] || a.max[axis] != b.max[axis]) return false;
    return true;
}

bool is_bounded(const Extent& box) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.min[axis] >= -Bvh8Nodes::largest && box.max[axis] <= Bvh8Nodes::largest)) return false;
    return true;
}

// Places of an array, in order, which lie in runs.
class Places {
public:
    void add(std::size_t begin, std::size_t end) {
        if (begin >= end) return;
        runs_.push_back({count_, begin});
        count_ += end - begin;
    }
    std::size_t count() const { return count_; }

    // Where the i-th place is, and how many lie in one run from there on.
    std::pair<std::size_t, std::size_t> from(std::size_t i) const {
        const auto next = std::ranges::upper_bound(runs_, i, {}, &Run::before);
        const std::size_t end = next == runs_.end() ? count_ : next->before;
        const Run& run = *(next - 1);
        return {run.begin + (i - run.before), end - i};
    }

private:
    struct Run {
        std::size_t before, begin;  // how many places come before it, and its first
    };
    std::vector<Run> runs_;
    std::size_t count_ = 0;
};

// Of some primitives.
struct Bounds {
    ReferenceRange range;  // of their references
    Extent corners;        // of triangles; a reference's box does not go as far

    void add(const Bounds& other) {
        range.add(other.range);
        corners.add(other.corners);
    }
};

}  // namespace

// A piece of a part, sorted: the left ones first, and the right sides of those that were cut.
struct References::SortedPiece {
    ReferenceRange left, right;
    std::vector<Reference> cut_off;
};

// The sum of what `work` makes of each piece of a part.
template <class Result, class Work>
Result References::in_pieces(const ReferenceRange& part, ThreadPool& threads, const Work& work) const {
    if (part.size() <= piece_size_) return work(part.begin, part.end);
    std::vector<Result> results((part.size() + piece_size_ - 1) / piece_size_);
    threads.for_each_piece(part.size(), piece_size_, [&](std::size_t begin, std::size_t end) {
        results[begin / piece_size_] = work(part.begin + begin, part.begin + end);
    });
    for (std::size_t i = 1; i < results.size(); ++i) results[0].add(results[i]);
    return std::move(results[0]);
}

References::References(const TriangleRuns& triangles, std::span<const Box> others, const Bvh8BuildOptions& options,
                       ThreadPool& threads)
    : triangles_(triangles),
      piece_size_(std::clamp<std::size_t>((triangles.size() + others.size()) / 8, min_piece_size, 16'384)) {
    const std::size_t count = triangles.size() + others.size();
    const auto wanted = static_cast<std::size_t>(options.max_duplicates * static_cast<double>(count));
    const std::size_t room = std::min(wanted, Bvh8Child::max_primitives - count);
    all_ = LargeArray<Reference>(count + room);
    const auto bounds = in_pieces<Bounds>({0, count}, threads, [&](std::size_t begin, std::size_t end) {
        Bounds piece;
        for (std::size_t i = begin; i < std::min(end, triangles.size()); ++i) {
            const Triangle triangle = triangles[i];
            const FourFloats a = four(triangle.a), b = four(triangle.b), c = four(triangle.c);
            const Extent box{smaller(smaller(a, b), c), larger(larger(a, b), c)};
            piece.corners.add(box);
            piece.range.add(all_[i] = Reference(box.min, box.max, i, Kind::triangle));
        }
        for (std::size_t i = std::max(begin, triangles.size()); i < end; ++i) {
            const Box& box = others[i - triangles.size()];
            piece.range.add(all_[i] = Reference(four(box.min), four(box.max), i - triangles.size(), Kind::other));
        }
        return piece;
    });
    root_ = bounds.range;
    corners_ = bounds.corners;
    root_.end = count;
    // What lies beyond the largest plane of a box is not in its reference's box, and would be lost by a cut.
    if (is_bounded(root_.box)) root_.room = room;
    min_overlap_ = least_overlap * root_.box.half_area();
}

bool References::fit_in_leaf(const ReferenceRange& part) const {
    if (part.size() == 1) return true;
    if (part.size() > bvh8_width) return false;
    const std::span<const Reference> found = of(part);
    if (part.end <= walls_ && !is_same(found[0].box(), part.box)) return false;
    return found.back().is_triangle() && std::ranges::all_of(found, &Reference::is_triangle);
}

std::vector<ReferenceRange> References::parts_of_root(ThreadPool& threads) {
    const auto is_wall = [&](const Walls& walls, const Reference& one) {
        return walls.may_have(one) && walls.has(one, triangles_[one.number()]);
    };
    const auto walls = in_pieces<Walls>(root_, threads, [&](std::size_t begin, std::size_t end) {
        Walls found(root_.box);
        for (std::size_t i = begin; i < end; ++i)
            if (is_wall(found, all_[i])) found.add(triangles_[all_[i].number()]);
        return found;
    });
    if (!walls.make_a_room(root_.size())) return {root_};
    const ReferenceRange no_places_after{root_.begin, root_.end, 0, root_.box, root_.centers};
    auto [of_walls, rest] = partition(no_places_after, threads, [&](const Reference& one, std::vector<Reference>&) {
        return is_wall(walls, one) ? Side::left : Side::right;
    });
    rest.room = root_.room;
    walls_ = of_walls.end;
    return {of_walls, rest};
}

References::Sides References::split(const ReferenceRange& part, int depth, ThreadPool& threads) {
    if (depth >= halving_depth) return halves(part);
    const Binning binning(part);
    const auto bins = in_pieces<Bins>(part, threads, [&](std::size_t begin, std::size_t end) {
        Bins filled(binning.count);
        for (std::size_t i = begin; i < end; ++i) filled.add(all_[i], binning.of(all_[i]));
        return filled;
    });
    Split best;
    for (int axis = 0; axis < 3; ++axis)
        if (binning.scale[axis] > 0) bins.try_axis(axis, best);

    if (part.room > 0 && (best.cost == infinity || bins.overlap(best) > min_overlap_)) {
        const PlaneBinning planes(part.box, part.size());
        const PlaneSplit plane = best_plane(part, planes, threads);
        if (plane.cost < best.cost) return split_by_plane(part, planes, plane, threads);
    }
    if (best.cost == infinity) return halves(part);
    return partition(part, threads, [&](const Reference& one, std::vector<Reference>&) {
        return binning.of(one)[best.axis] < best.bin ? Side::left : Side::right;
    });
}

PlaneSplit References::best_plane(const ReferenceRange& part, const PlaneBinning& binning, ThreadPool& threads) const {
    const auto bins = in_pieces<PlaneBins>(part, threads, [&](std::size_t begin, std::size_t end) {
        PlaneBins filled(binning.count);
        for (std::size_t i = begin; i < end; ++i) filled.add(all_[i], binning);
        return filled;
    });
    return bins.best(binning, part.size(), part.room);
}

References::Sides References::split_by_plane(const ReferenceRange& part, const PlaneBinning& binning,
                                             const PlaneSplit& plane, ThreadPool& threads) {
    const auto [axis, bin, cost] = plane;
    const float at = binning.border(axis, bin);
    return partition(part, threads, [&, axis = axis, bin = bin](Reference& one, std::vector<Reference>& cut_off) {
        const Extent box = one.box();
        if (binning.bins_of(box.max)[axis] < bin) return Side::left;
        if (binning.bins_of(box.min)[axis] >= bin) return Side::right;
        const auto [below, above] = cut_by_plane(one, triangle_of(one), axis, at);
        if (is_empty(below)) {
            if (!is_empty(above)) one = one.in(above);
            return Side::right;
        }
        if (!is_empty(above)) cut_off.push_back(one.in(above));
        one = one.in(below);
        return Side::left;
    });
}

template <class SideOf>
References::SortedPiece References::sort_piece(std::size_t begin, std::size_t end, const SideOf& side_of) {
    SortedPiece piece;
    const auto is_left = [&](Reference& one) {
        const bool found = side_of(one, piece.cut_off) == Side::left;
        if (found)
            piece.left.add(one);
        else
            piece.right.add(one);
        return found;
    };
    std::size_t i = begin;
    for (std::size_t last = end; i < last; ++i) {
        if (is_left(all_[i])) continue;
        do --last;
        while (last > i && !is_left(all_[last]));
        if (last == i) break;
        std::swap(all_[i], all_[last]);
    }
    piece.left.begin = begin;
    piece.left.end = piece.right.begin = i;
    piece.right.end = end;
    return piece;
}

template <class SideOf>
References::Sides References::partition(const ReferenceRange& part, ThreadPool& threads, const SideOf& side_of) {
    std::vector<SortedPiece> pieces((part.size() + piece_size_ - 1) / piece_size_);
    const auto sort = [&](std::size_t begin, std::size_t end) {
        pieces[begin / piece_size_] = sort_piece(part.begin + begin, part.begin + end, side_of);
    };
    if (pieces.size() == 1)
        sort(0, part.size());
    else
        threads.for_each_piece(part.size(), piece_size_, sort);
    ReferenceRange left, right;
    std::size_t middle = part.begin, end = part.end;
    for (const SortedPiece& piece : pieces) {
        left.add(piece.left);
        right.add(piece.right);
        middle += piece.left.size();
    }
    if (pieces.size() > 1) exchange(pieces, middle, threads);
    for (const SortedPiece& piece : pieces)
        for (const Reference& one : piece.cut_off) {
            right.add(one);
            all_[end++] = one;
        }
    const std::size_t room = part.end + part.room - end;
    if (middle == part.begin || middle == end) return halves({part.begin, end, room});  // all lies on one side
    left.begin = part.begin;
    left.end = right.begin = middle;
    right.end = end;
    return with_room({left, right}, room);
}

// Exchanges what the pieces have on the wrong side of the middle: on both sides the same number, in order.
void References::exchange(std::span<const SortedPiece> pieces, std::size_t middle, ThreadPool& threads) {
    Places rights, lefts;
    for (const SortedPiece& piece : pieces) {
        rights.add(piece.right.begin, std::min(middle, piece.right.end));
        lefts.add(std::max(middle, piece.left.begin), piece.left.end);
    }
    threads.for_each_piece(rights.count(), piece_size_, [&](std::size_t begin, std::size_t end) {
        while (begin < end) {
            const auto [right, rights_there] = rights.from(begin);
            const auto [left, lefts_there] = lefts.from(begin);
            const std::size_t count = std::min({end - begin, rights_there, lefts_there});
            std::swap_ranges(all_.data() + right, all_.data() + right + count, all_.data() + left);
            begin += count;
        }
    });
}

// Divides the free places after two parts between them, by the work of each.
References::Sides References::with_room(Sides sides, std::size_t room) {
    auto& [left, right] = sides;
    if (room == 0) return sides;
    const double of_left = double{left.box.half_area()} * static_cast<double>(left.size()),
                 of_right = double{right.box.half_area()} * static_cast<double>(right.size());
    const double share = of_left + of_right > 0 ? of_left / (of_left + of_right) : 0.5;
    left.room = static_cast<std::size_t>(share * static_cast<double>(room));
    right.room = room - left.room;
    const std::size_t moved = std::min(left.room, right.size());
    std::copy_n(all_.data() + right.begin, moved, all_.data() + right.end + left.room - moved);
    right.begin += left.room;
    right.end += left.room;
    return sides;
}

References::Sides References::halves(const ReferenceRange& part) {
    const std::size_t middle = part.begin + part.size() / 2;
    return with_room({part_of(part.begin, middle), part_of(middle, part.end)}, part.room);
}

ReferenceRange References::part_of(std::size_t begin, std::size_t end) const {
    ReferenceRange part{begin, end};
    for (std::size_t i = begin; i < end; ++i) part.add(all_[i]);
    return part;
}

}  // namespace raylab::bvh8_parts
