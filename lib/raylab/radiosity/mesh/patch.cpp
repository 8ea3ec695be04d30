#include "raylab/radiosity/mesh/patch.h"

#include "raylab/radiosity/form_factor/convex_polygon.h"

#include <algorithm>

namespace raylab {

namespace {

// The centroid: where half-spheres stand and rays start.
Vec3d center_of(std::span<const Vec3d> polygon, const Vec3d& normal) {
    Vec3d sum{0, 0, 0};
    double all = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const double area = dot(cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]), normal);
        sum += area / 3 * (polygon[0] + polygon[i - 1] + polygon[i]);
        all += area;
    }
    return sum / all;
}

// A part of a patch. It keeps the patch's normal: a small polygon's own would be that of its rounding.
Patch part(const Patch& of, std::span<const Vec3d> corners) {
    Patch result = of;
    std::ranges::copy(corners, result.corners.begin());
    ++result.level;
    result.area = polygon_area(result.polygon());
    result.center = center_of(result.polygon(), result.normal);
    return result;
}

}  // namespace

std::optional<Patch> patch_of(std::span<const Vec3d> corners, std::uint32_t facet, FacetSide side) {
    Patch patch{.corner_count = static_cast<std::uint32_t>(corners.size()), .facet = facet, .side = side};
    std::ranges::copy(corners, patch.corners.begin());
    const Vec3d area = area_vector(patch.polygon());
    patch.area = glm::length(area);
    if (!(patch.area > 0)) return std::nullopt;
    patch.normal = area / patch.area;
    patch.center = center_of(patch.polygon(), patch.normal);
    return patch;
}

std::array<Patch, 4> quarters(const Patch& patch) {
    const auto& c = patch.corners;
    const std::uint32_t n = patch.corner_count;
    const auto middle = [&](std::uint32_t i) { return 0.5 * (c[i] + c[(i + 1) % n]); };
    const Vec3d a = middle(0), b = middle(1), d = middle(n - 1);
    if (n == 3)
        return {part(patch, std::array{c[0], a, d}), part(patch, std::array{a, c[1], b}),
                part(patch, std::array{d, b, c[2]}), part(patch, std::array{b, d, a})};
    const Vec3d opposite = middle(2), center = 0.5 * (a + opposite);
    return {part(patch, std::array{c[0], a, center, d}), part(patch, std::array{a, c[1], b, center}),
            part(patch, std::array{center, b, c[2], opposite}), part(patch, std::array{d, center, opposite, c[3]})};
}

QuarterPlace quarter_at(std::uint32_t corner_count, const std::array<double, 4>& weights) {
    const auto& w = weights;
    if (corner_count == 3) {
        for (std::uint32_t corner = 0; corner < 3; ++corner)
            if (w[corner] >= 0.5) {
                std::array<double, 4> inside{2 * w[0], 2 * w[1], 2 * w[2], 0};
                inside[corner] -= 1;
                return {corner, inside};
            }
        return {3, {1 - 2 * w[0], 1 - 2 * w[1], 1 - 2 * w[2], 0}};
    }
    const double u = 2 * (w[1] + w[2]), v = 2 * (w[2] + w[3]);  // the bilinear weights' parameters, doubled
    const bool right = u >= 1, upper = v >= 1;
    const double s = right ? u - 1 : u, t = upper ? v - 1 : v;
    const std::uint32_t quarter = upper ? (right ? 2 : 3) : (right ? 1 : 0);
    return {quarter, {(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t}};
}

double longest_side(const Patch& patch) {
    double longest = 0;
    for (std::uint32_t i = 0; i < patch.corner_count; ++i)
        longest = std::max(longest, glm::distance(patch.corners[i], patch.corners[(i + 1) % patch.corner_count]));
    return longest;
}

}  // namespace raylab
