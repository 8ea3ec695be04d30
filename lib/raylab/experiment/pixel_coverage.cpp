#include "raylab/experiment/pixel_coverage.h"

#include <cmath>
#include <vector>

namespace raylab {

namespace {

using Outline = std::vector<glm::dvec2>;

// The part of the outline in which `inside` is not negative; inside is linear, so a crossing is an interpolation
// (Sutherland and Hodgman, "Reentrant Polygon Clipping", CACM 17(1), 1974).
template <class Side>
Outline clipped(const Outline& outline, const Side& inside) {
    Outline result;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 from = outline[i], to = outline[(i + 1) % outline.size()];
        const double at_from = inside(from), at_to = inside(to);
        if (at_from >= 0) result.push_back(from);
        if ((at_from >= 0) != (at_to >= 0)) result.push_back(from + at_from / (at_from - at_to) * (to - from));
    }
    return result;
}

}  // namespace

double pixel_coverage(std::span<const glm::dvec2> polygon, int column, int row) {
    Outline outline;
    for (const glm::dvec2& p : polygon) outline.push_back(p - glm::dvec2(column, row));  // near 0: no digits lost below
    outline = clipped(outline, [](const glm::dvec2& p) { return p.x; });
    outline = clipped(outline, [](const glm::dvec2& p) { return 1 - p.x; });
    outline = clipped(outline, [](const glm::dvec2& p) { return p.y; });
    outline = clipped(outline, [](const glm::dvec2& p) { return 1 - p.y; });
    double doubled = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 p = outline[i], q = outline[(i + 1) % outline.size()];
        doubled += p.x * q.y - q.x * p.y;
    }
    return std::abs(doubled) / 2;
}

}  // namespace raylab
