#include "raylab/accelerator/grid/grid.h"

#include "raylab/accelerator/grid/grid_walk.h"
#include "raylab/accelerator/list.h"
#include "raylab/accelerator/mailboxes.h"
#include "raylab/accelerator/sorted_primitives.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raylab {

namespace {

bool is_finite(const Box& box) {
    const auto finite = [](const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    return finite(box.min) && finite(box.max);
}

// Boxes that reach to infinity cannot be put into cells.
SortedPrimitives with_finite_boxes(const Scene& scene) {
    SortedPrimitives sorted(scene);
    std::vector<std::uint32_t> bounded;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < sorted.boxes.size(); ++i) {
        const bool finite = is_finite(sorted.boxes[i]);
        (finite ? bounded : sorted.unbounded).push_back(sorted.bounded[i]);
        if (finite) boxes.push_back(sorted.boxes[i]);
    }
    std::ranges::sort(sorted.unbounded);
    sorted.bounded = std::move(bounded);
    sorted.boxes = std::move(boxes);
    return sorted;
}

template <class At>
void for_each_cell(const GridPlanes::Range& range, const At& at) {
    for (int z = range.first[2]; z <= range.last[2]; ++z)
        for (int y = range.first[1]; y <= range.last[1]; ++y)
            for (int x = range.first[0]; x <= range.last[0]; ++x) at(Cell{x, y, z});
}

constexpr auto no_record = [](std::size_t, std::size_t) {};

}  // namespace

Grid::Grid(const Scene& scene, const GridOptions& options) : Grid(with_finite_boxes(scene), options) {}

Grid::Grid(const SortedPrimitives& sorted, const GridOptions& options)
    : mailboxes_(options.mailboxes),
      planes_(grid_planes(sorted.boxes, options.density)),
      bounded_(sorted.all, {}),
      everywhere_(sorted.all, {}) {
    if (!planes_.exist()) {
        std::vector<std::uint32_t> all = sorted.unbounded;
        all.insert(all.end(), sorted.bounded.begin(), sorted.bounded.end());
        everywhere_ = Primitives(sorted.all, all);
        return;
    }
    std::vector<GridPlanes::Range> ranges;
    for (const Box& box : sorted.boxes) ranges.push_back(planes_.reached(box));
    // The primitives of neighbouring cells lie next to each other in memory.
    std::vector<std::uint32_t> order(sorted.boxes.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return planes_.index(ranges[i].first); });
    std::vector<GridPlanes::Range> ordered;
    for (const std::uint32_t i : order) ordered.push_back(ranges[i]);
    bounded_ = sorted.in_order(std::move(order));
    everywhere_ = sorted.without_bounds();
    fill(ordered);
}

void Grid::fill(std::span<const GridPlanes::Range> ranges) {
    struct Entry {
        std::uint32_t cell, primitive;
    };
    std::vector<Entry> entries;
    for (std::uint32_t i = 0; i < ranges.size(); ++i)
        for_each_cell(ranges[i], [&](const Cell& cell) {
            if (ranges[i].size() > 1 && !bounded_.reaches(i, planes_.grown(cell))) return;
            entries.push_back({static_cast<std::uint32_t>(planes_.index(cell)), i});
        });
    first_.assign(planes_.cell_count() + 1, 0);
    for (const Entry& entry : entries) ++first_[entry.cell + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    inside_.resize(entries.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    occupied_.assign(planes_.cell_count() / 64 + 1, 0);
    for (const Entry& entry : entries) {
        inside_[next[entry.cell]++] = entry.primitive;
        occupied_[entry.cell / 64] |= std::uint64_t{1} << (entry.cell % 64);
    }
}

std::span<const std::uint32_t> Grid::in_cell(std::size_t index) const {
    return std::span(inside_).subspan(first_[index], first_[index + 1] - first_[index]);
}

std::size_t Grid::bytes() const {
    return planes_.bytes() + (first_.capacity() + inside_.capacity()) * sizeof(std::uint32_t) +
           occupied_.capacity() * sizeof(std::uint64_t) + bounded_.bytes() + everywhere_.bytes();
}

template <class Ask>
auto Grid::with_mailboxes(Traversal& traversal, const Ask& ask) const {
    if (mailboxes_ == MailboxKind::ray_id) {
        traversal.mailboxes.next_ray(bounded_.size());
        return ask(traversal.mailboxes);
    }
    if (mailboxes_ == MailboxKind::small_cache) {
        SmallMailbox before;
        return ask(before);
    }
    NoMailboxes before;
    return ask(before);
}

// A hit beyond the cell in which it was found is kept all the same: the traversal ends where the next cell surely lies
// behind it. So a primitive that was tested before need not be tested again.
template <class Before, class Record>
std::optional<Hit> Grid::nearest(const Ray& ray, Traversal& traversal, Before& before, const Record& record) const {
    Nearest nearest(ray);
    for (std::size_t i = 0; i < everywhere_.size(); ++i) everywhere_.test(i, ray, nearest, traversal);
    if (!planes_.exist()) return nearest.hit();
    const GridWalk start(planes_, ray);
    GridWalk walk = start;  // a copy, which no call can change: its numbers stay in registers
    if (!walk.is_sure()) {
        for (std::size_t i = 0; i < bounded_.size(); ++i) bounded_.test(i, ray, nearest, traversal);
        return nearest.hit();
    }
    walk.set_end(nearest.limit());
    const TriangleQuickReject quick_reject = bounded_.quick_reject(ray);
    for (bool inside = walk.enters(); inside; inside = walk.next()) {
        ++traversal.steps;
        const std::uint64_t tests_before = traversal.primitive_tests;
        if (!is_empty(walk.index())) {
            for (const std::uint32_t i : in_cell(walk.index()))
                if (!before.hit_before(i)) bounded_.test(i, ray, quick_reject, nearest, traversal);
            walk.set_end(nearest.limit());
        }
        record(walk.index(), traversal.primitive_tests - tests_before);
    }
    return nearest.hit();
}

std::optional<Hit> Grid::closest(const Ray& ray, Traversal& traversal) const {
    return with_mailboxes(traversal, [&](auto& before) { return nearest(ray, traversal, before, no_record); });
}

template <class Before>
bool Grid::hits_any(const Ray& ray, Traversal& traversal, Before& before) const {
    for (std::size_t i = 0; i < everywhere_.size(); ++i)
        if (everywhere_.hits(i, ray, traversal)) return true;
    if (!planes_.exist()) return false;
    const GridWalk start(planes_, ray);
    GridWalk walk = start;  // a copy, which no call can change: its numbers stay in registers
    if (!walk.is_sure()) return occluded_by_any(bounded_, ray, traversal);
    const TriangleQuickReject quick_reject = bounded_.quick_reject(ray);
    for (bool inside = walk.enters(); inside; inside = walk.next()) {
        ++traversal.steps;
        if (is_empty(walk.index())) continue;
        for (const std::uint32_t i : in_cell(walk.index())) {
            if (before.hit_before(i) || !bounded_.hits(i, ray, quick_reject, traversal)) continue;
            traversal.stopped_by(i);
            return true;
        }
    }
    return false;
}

bool Grid::occluded(const Ray& ray, Traversal& traversal) const {
    if (traversal.stopped_again([&](std::size_t i) { return bounded_.hits(i, ray, traversal); })) return true;
    return with_mailboxes(traversal, [&](auto& before) { return hits_any(ray, traversal, before); });
}

Outline Grid::outline() const {
    Outline outline;
    if (!planes_.exist()) return outline;
    const std::vector<std::uint32_t> places = bounded_.places();
    outline.nodes.push_back(
        {.bound = Box{planes_.bounds({0, 0, 0}).min, planes_.bounds(planes_.cell(planes_.cell_count() - 1)).max}});
    for (std::size_t index = 0; index < planes_.cell_count(); ++index) {
        if (is_empty(index)) continue;
        outline.nodes[0].children.push_back(static_cast<std::uint32_t>(outline.nodes.size()));
        Outline::Node cell{.bound = planes_.bounds(planes_.cell(index))};
        for (const std::uint32_t i : in_cell(index)) cell.primitives.push_back(places[i]);
        outline.nodes.push_back(std::move(cell));
    }
    return outline;
}

std::vector<Visit> Grid::visits(const Ray& ray) const {
    std::vector<Visit> result;
    Traversal traversal;
    const auto record = [&](std::size_t index, std::uint64_t tests) {
        result.push_back(
            {planes_.bounds(planes_.cell(index)), is_empty(index) ? Visit::Kind::empty : Visit::Kind::leaf, tests});
    };
    with_mailboxes(traversal, [&](auto& before) { return nearest(ray, traversal, before, record); });
    return result;
}

}  // namespace raylab
