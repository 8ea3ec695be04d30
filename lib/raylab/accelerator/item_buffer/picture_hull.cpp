#include "raylab/accelerator/item_buffer/picture_hull.h"

#include "raylab/geometry/local_frame.h"
#include "raylab/geometry/shape_parts.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <span>

namespace raylab {

namespace {

Vec3d corner(const Box& box, std::size_t i) {
    return {(i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y, (i & 4) ? box.max.z : box.min.z};
}

// A little less than how far the nearest point of the box is.
double distance(const Box& box, const Vec3d& eye) {
    const auto gap = [&](int axis) { return std::max({box.min[axis] - eye[axis], eye[axis] - box.max[axis], 0.0}); };
    const double x = gap(0), y = gap(1), z = gap(2);
    return std::sqrt(x * x + y * y + z * z) * PictureView::below;
}

void add(PictureHull& to, const Vec3d& corner) {
    to.corners[to.count++] = corner;
    to.size = std::max(to.size, sum_of_sizes(corner));
}

PictureHull of_box(const PictureView& view, const Box& box) {
    PictureHull result;
    for (std::size_t i = 0; i < 8; ++i) add(result, corner(box, i));
    result.distance = result.nearest = distance(box, view.eye());
    return result;
}

PictureHull of_triangle(const PictureView& view, const Triangle& triangle, const Affine& placement, const Box& box) {
    PictureHull result;
    for (const Vec3f& vertex : {triangle.a, triangle.b, triangle.c}) {
        const Vec3d p = convert<double>(vertex);
        add(result, placement.is_identity() ? p : transform_point(placement, p));
        if (placement.is_identity()) continue;
        double stretch = 0;
        for (const Vec3f& column : placement.columns) stretch += sum_of_sizes(convert<double>(column));
        const double sizes = stretch * sum_of_sizes(p) + sum_of_sizes(convert<double>(placement.translation));
        result.off = std::max(result.off, 32 * unit_roundoff<double> * sizes);
    }
    result.distance = result.nearest = distance(box, view.eye());
    return result;
}

// Corners on the unit circle, and how much farther they must be from its center for the edges not to cut the circle:
// 1 / cos(22.5 degrees).
constexpr double diagonal = std::numbers::sqrt2 / 2, far_corner = 1.0823922002923940;
constexpr std::array<std::array<double, 2>, 8> octagon{{{1, 0},
                                                        {diagonal, diagonal},
                                                        {0, 1},
                                                        {-diagonal, diagonal},
                                                        {-1, 0},
                                                        {-diagonal, -diagonal},
                                                        {0, -1},
                                                        {diagonal, -diagonal}}};

// The rays that hit a sphere fill a cone (a cylinder, where they are parallel), and cross the plane through the center
// at right angles to its axis in a disk: an octagon about that. Absent: the eye is too near.
std::optional<PictureHull> of_sphere(const PictureView& view, const Sphere& sphere) {
    const Vec3d center = convert<double>(sphere.center), from_eye = center - view.eye();
    const double radius = sphere.radius, away = glm::length(from_eye);
    // So far away, the difference of squares below is at least a fiftieth of either: ten roundings leave the reach
    // within 2^-43 of itself, and 1e-6 is 2^-20.
    constexpr double near = 1.01, outward = 1 + 1e-6;
    if (view.perspective() && !(away > near * radius)) return std::nullopt;
    const double widened = view.perspective() ? away / std::sqrt(away * away - radius * radius) : 1;
    const double reach = radius * widened * far_corner * outward;
    const LocalFrame frame = frame_around(view.perspective() ? from_eye / away : view.forward());
    PictureHull result;
    for (const auto& [x, y] : octagon) add(result, center + (frame.x * x + frame.y * y) * reach);
    result.thickness = radius;
    result.distance = away * PictureView::below;
    result.nearest = (away - radius) * PictureView::below;
    return result;
}

}  // namespace

PictureHull picture_hull(const PictureView& view, const Target& target, const Box& box) {
    if (target.motion) return of_box(view, box);  // the box holds it at all times
    if (const auto triangle = triangle_of(*target.shape, target.part))
        return of_triangle(view, *triangle, *target.placement, box);
    const auto* sphere = std::get_if<Sphere>(target.shape);
    if (sphere && target.placement->is_identity())
        if (const auto found = of_sphere(view, *sphere)) return *found;
    return of_box(view, box);
}

}  // namespace raylab
