#include "raylab/radiosity/mesh/convex_room.h"

#include "raylab/radiosity/form_factor/convex_polygon.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

// Whether all facets lie on one side of this one's plane. Corners may be off by the rounding of floats, and so do rays
// start: what stands out by that hides nothing that they could tell.
bool has_all_on_one_side(const Facet& one, const std::vector<Facet>& facets, double rounding) {
    const Vec3d normal = polygon_normal(one.corners);
    bool in_front = false, behind = false;
    for (const Facet& facet : facets)
        for (const Vec3d& corner : facet.corners) {
            const double height = dot(normal, corner - one.corners[0]);
            in_front |= height > rounding;
            behind |= height < -rounding;
            if (in_front && behind) return false;
        }
    return true;
}

}  // namespace

bool is_convex_room(const std::vector<Facet>& facets) {
    constexpr std::size_t most = 1000;
    if (facets.size() > most) return false;
    double largest = 0;
    for (const Facet& facet : facets)
        for (const Vec3d& corner : facet.corners)
            largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
    const double rounding = 0x1p-22 * largest;
    return std::ranges::all_of(facets,
                               [&](const Facet& facet) { return has_all_on_one_side(facet, facets, rounding); });
}

}  // namespace raylab
