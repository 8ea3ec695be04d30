#include "raylab/radiosity/mesh/contact_lines.h"

#include "raylab/radiosity/form_factor/convex_polygon.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace raylab {

namespace {

struct Segment {
    Vec3d from, to;
};

// How far a point may lie from a plane and still be on it: corners are floats.
double on_plane(const Facet& facet) {
    double largest = 0;
    for (const Vec3d& corner : facet.corners)
        for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(corner[axis]));
    return 1e-6 * largest;
}

// Where a facet meets a plane: its sides in the plane, or the line on which it goes through.
std::vector<Segment> meeting(const Facet& facet, const PatchPlane& plane, double tolerance) {
    std::vector<Segment> sides;
    std::vector<Vec3d> points;
    const auto& c = facet.corners;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const Vec3d &a = c[i], &b = c[(i + 1) % c.size()];
        const double at_a = plane.height(a), at_b = plane.height(b);
        const bool a_on = std::abs(at_a) <= tolerance, b_on = std::abs(at_b) <= tolerance;
        if (a_on && b_on) sides.push_back({a, b});
        if (a_on) points.push_back(a);
        if (!a_on && !b_on && (at_a < 0) != (at_b < 0)) points.push_back(glm::mix(a, b, at_a / (at_a - at_b)));
    }
    if (sides.empty() && points.size() == 2) sides.push_back({points[0], points[1]});
    return sides;
}

// The length of a segment inside a convex polygon of the same plane.
double length_inside(Segment segment, const std::vector<Vec3d>& polygon, const Vec3d& normal) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d side = polygon[(i + 1) % polygon.size()] - polygon[i];
        const PatchPlane inner{polygon[i], glm::normalize(cross(normal, side))};
        const double at_from = inner.height(segment.from), at_to = inner.height(segment.to);
        if (at_from <= 0 && at_to <= 0) return 0;
        const Vec3d crossing =
            at_from == at_to ? segment.from : glm::mix(segment.from, segment.to, at_from / (at_from - at_to));
        if (at_from < 0) segment.from = crossing;
        if (at_to < 0) segment.to = crossing;
    }
    return glm::distance(segment.from, segment.to);
}

// Two parts of a polygon, or the polygon, if the segment does not lie in it.
std::vector<std::vector<Vec3d>> parts(const std::vector<Vec3d>& polygon, const Segment& segment, const Vec3d& normal,
                                      double tolerance) {
    if (length_inside(segment, polygon, normal) <= tolerance) return {polygon};
    const PatchPlane across{segment.from, glm::normalize(cross(normal, segment.to - segment.from))};
    auto front = clipped_to_front(polygon, across, tolerance),
         back = clipped_to_front(polygon, across.turned(), tolerance);
    if (front.empty() || back.empty()) return {polygon};
    return {std::move(front), std::move(back)};
}

// A facet has three or four corners: a polygon with more becomes a fan.
void add_facets(const std::vector<Vec3d>& polygon, const Facet& like, std::uint32_t smooth,
                std::vector<Facet>& facets) {
    const auto add = [&](std::vector<Vec3d> corners) {
        facets.push_back({std::move(corners), like.object, like.part, like.occluder, smooth});
    };
    if (polygon.size() <= 4) return add(polygon);
    add({polygon[0], polygon[1], polygon[2], polygon[3]});
    for (std::size_t i = 4; i < polygon.size(); ++i) add({polygon[0], polygon[i - 1], polygon[i]});
}

}  // namespace

PolygonalModel with_contact_lines(PolygonalModel model) {
    std::uint32_t groups = 0;
    for (const Facet& facet : model.facets) groups = std::max(groups, facet.smooth + 1);
    std::vector<Facet> cut;
    for (const Facet& facet : model.facets) {
        const PatchPlane plane = patch_plane(facet.corners);
        const double tolerance = on_plane(facet);
        std::vector<std::vector<Vec3d>> pieces{facet.corners};
        for (const Facet& other : model.facets) {
            if (other.occluder == facet.occluder) continue;
            for (const Segment& segment : meeting(other, plane, tolerance)) {
                std::vector<std::vector<Vec3d>> next;
                for (const auto& piece : pieces)
                    for (auto& part : parts(piece, segment, plane.normal, tolerance)) next.push_back(std::move(part));
                pieces = std::move(next);
            }
        }
        for (const auto& piece : pieces) add_facets(piece, facet, pieces.size() == 1 ? facet.smooth : groups++, cut);
    }
    model.facets = std::move(cut);
    return model;
}

}  // namespace raylab
