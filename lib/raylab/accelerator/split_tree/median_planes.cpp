#include "raylab/accelerator/split_tree/plane_rule.h"

#include "raylab/accelerator/split_tree/finite_cell.h"

#include <algorithm>
#include <vector>

namespace raylab {

namespace {

// The plane, if it separates enough parts: a part that lies on both sides is in both halves, and further cuts would
// only copy it.
std::optional<SplitPlane> parting(const Box& cell, std::span<const CellPart> parts, std::size_t axis, double place) {
    const auto i = static_cast<int>(axis);
    const auto plane = cast<float>(place);
    // There is no float left between the sides of the cell.
    if (!(plane > cell.min[i] && plane < cell.max[i])) return std::nullopt;
    const auto cut = std::ranges::count_if(
        parts, [&](const CellPart& part) { return part.box.min[i] < plane && part.box.max[i] > plane; });
    if (2 * static_cast<std::size_t>(cut) > parts.size()) return std::nullopt;
    return SplitPlane{axis, plane};
}

// Tries the longest side first; place_along(axis) returns the coordinate of the plane.
template <class PlaceAlong>
std::optional<SplitPlane> first_parting(const Box& cell, std::span<const CellPart> parts,
                                        const PlaceAlong& place_along) {
    for (const std::size_t axis : longest_first(cell))
        if (const auto plane = parting(cell, parts, axis, place_along(static_cast<int>(axis)))) return plane;
    return std::nullopt;
}

double median_center(std::span<const CellPart> parts, int axis) {
    std::vector<double> centers;
    for (const CellPart& part : parts) centers.push_back(finite(part.box).center()[axis]);
    const auto middle = centers.begin() + static_cast<std::ptrdiff_t>(centers.size() / 2);
    std::ranges::nth_element(centers, middle);
    return *middle;
}

}  // namespace

PlaneRule spatial_median(std::size_t leaf) {
    return [leaf](const Box& whole, std::span<const CellPart> parts) -> std::optional<SplitPlane> {
        if (parts.size() <= leaf) return std::nullopt;
        const Box cell = finite(whole);
        return first_parting(cell, parts, [&](int axis) { return cell.center()[axis]; });
    };
}

PlaneRule object_median(std::size_t leaf) {
    return [leaf](const Box& whole, std::span<const CellPart> parts) -> std::optional<SplitPlane> {
        if (parts.size() <= leaf) return std::nullopt;
        return first_parting(finite(whole), parts, [&](int axis) { return median_center(parts, axis); });
    };
}

}  // namespace raylab
