#include "raylab/accelerator/bvh/part_halves.h"

#include "raylab/accelerator/bvh/cheapest_cut.h"
#include "raylab/accelerator/bvh/spatial_plane.h"
#include "raylab/accelerator/sorted_primitives.h"
#include "raylab/number/scalar.h"

#include <numeric>

namespace raylab {

namespace {

// One side of a cut: first with only the parts that lie wholly on it, then with the straddlers that are added.
struct Half {
    std::vector<CellPart> parts;
    CutSide side;

    void add(const CellPart& part) {
        parts.push_back(part);
        side.add({part.box, 1});
    }
    double work_with(const Box& box) const { return CutSide{unite(side.box, box), side.count}.work(); }
    double work_without_one() const { return CutSide{side.box, side.count - 1}.work(); }
};

struct Straddler {
    CellPart whole;
    CutPart cut;
};

// A straddler is on both sides at first; it is moved to one side alone where that lowers the cost.
void assign(const Straddler& straddler, Half& below, Half& above) {
    const auto& [whole, cut] = straddler;
    const double in_both = below.side.work() + above.side.work();
    const double only_below = below.work_with(whole.box) + above.work_without_one();
    const double only_above = above.work_with(whole.box) + below.work_without_one();
    if (only_below < in_both && only_below <= only_above) {
        below.parts.push_back(whole);
        below.side.box = unite(below.side.box, whole.box);
        --above.side.count;
    } else if (only_above < in_both) {
        above.parts.push_back(whole);
        above.side.box = unite(above.side.box, whole.box);
        --below.side.count;
    } else {
        below.parts.push_back({cut.below, whole.index});
        above.parts.push_back({cut.above, whole.index});
    }
}

struct Sides {
    Half below, above;
};

Sides sides_of(const SortedPrimitives& sorted, std::span<const CellPart> parts, int axis, float at) {
    Half below, above;
    std::vector<Straddler> straddlers;
    for (const CellPart& part : parts) {
        if (part.box.max[axis] <= at) {
            below.add(part);
        } else if (part.box.min[axis] >= at) {
            above.add(part);
        } else {
            const CutPart cut = cut_part(part, sorted.triangle(part.index), axis, at);
            if (!cut.below.is_empty() && !cut.above.is_empty())
                straddlers.push_back({part, cut});
            else if (!cut.below.is_empty())
                below.add({cut.below, part.index});
            else if (!cut.above.is_empty())
                above.add({cut.above, part.index});
        }
    }
    for (const Straddler& straddler : straddlers) {
        below.side.add({straddler.cut.below, 1});
        above.side.add({straddler.cut.above, 1});
    }
    for (const Straddler& straddler : straddlers) assign(straddler, below, above);
    return {std::move(below), std::move(above)};
}

}  // namespace

Box box_about(std::span<const CellPart> parts) {
    Box box;
    for (const CellPart& part : parts) box = unite(box, part.box);
    return box;
}

std::optional<PartCut> cut_between_centers(std::span<const CellPart> parts) {
    std::vector<Box> boxes;
    boxes.reserve(parts.size());
    for (const CellPart& part : parts) boxes.push_back(part.box);
    std::vector<std::uint32_t> all(parts.size());
    std::iota(all.begin(), all.end(), 0u);
    const BoxSplitter splitter(boxes, SplitRule::binned);
    const auto split = splitter.split(all);
    if (!split) return std::nullopt;
    PartCut cut{{}, split->cost};
    for (const std::uint32_t i : all)
        (splitter.center(i, split->axis) < split->place ? cut.halves.below : cut.halves.above).push_back(parts[i]);
    if (cut.halves.below.empty() || cut.halves.above.empty()) return std::nullopt;
    return cut;
}

std::optional<PartCut> cut_by_plane(const SortedPrimitives& sorted, std::span<const CellPart> parts, double max_cost,
                                    std::size_t most_cut) {
    const auto split = cheapest_plane(sorted, parts, most_cut);
    if (!split || !(split->cost < max_cost)) return std::nullopt;
    auto [below, above] = sides_of(sorted, parts, split->axis, cast<float>(split->place));
    PartCut cut{{std::move(below.parts), std::move(above.parts)}, below.side.work() + above.side.work()};
    const bool in_two = !cut.halves.below.empty() && !cut.halves.above.empty();
    const bool few_cut = cut.halves.below.size() + cut.halves.above.size() <= parts.size() + most_cut;
    return in_two && few_cut && cut.cost < max_cost ? std::optional(std::move(cut)) : std::nullopt;
}

PartHalves cut_in_the_middle(std::span<const CellPart> parts) {
    const auto middle = parts.begin() + static_cast<std::ptrdiff_t>(parts.size() / 2);
    return {{parts.begin(), middle}, {middle, parts.end()}};
}

}  // namespace raylab
