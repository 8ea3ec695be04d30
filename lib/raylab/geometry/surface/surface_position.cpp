#include "raylab/geometry/surface/surface_position.h"

#include "raylab/geometry/scaled_to_largest_one.h"
#include "raylab/geometry/surface/gradient.h"
#include "raylab/geometry/surface/surface_plane.h"
#include "raylab/geometry/transformed_normal.h"
#include "raylab/geometry/transformed_ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <memory>

namespace raylab {

namespace {

using detail::rounding_error, detail::roundings, detail::size_of;

// A point in the shape's own coordinates, how large the numbers were that it was made of, and the outward normal there,
// whose largest coordinate is one, or nearly so.
struct Local {
    Vec3d point;
    double size;
    Vec3d normal;
};

Local on(const Triangle& triangle, const Hit& hit) {
    const Vec3d a = convert<double>(triangle.a), b = convert<double>(triangle.b), c = convert<double>(triangle.c);
    return {a * (1 - hit.u - hit.v) + b * hit.u + c * hit.v, size_of(a) + size_of(b) + size_of(c),
            scaled_to_largest_one(cross(b - a, c - a))};
}

// Every formula below ends with a step that lands on the surface whatever its inputs were: an affine combination of the
// vertices, a foot on a plane, a direction from the center made as long as the surface is away. So only that step's own
// roundings count, and not how well the point was known before.

Local on(const SurfacePlane& flat, const Vec3d& p) { return {flat.foot(p), flat.size(p), flat.normal()}; }

Local on(const Sphere& sphere, const Vec3d& p) {
    const auto whole = in<double>(sphere);
    const auto [point, normal] = on_sphere(whole, p);
    return {point, size_of(whole), normal};
}

// F of gradient.h at a point.
double value(const EllipsoidOf<double>& ellipsoid, const Vec3d& p) {
    const Vec3d f = (p - ellipsoid.center) / ellipsoid.radii;
    return dot(f, f) - 1;
}

double value(const Revolution<double>& surface, const Vec3d& p) {
    const Vec3d above_base = p - surface.base;
    const double s = dot(above_base, surface.axis) / dot(surface.axis, surface.axis);
    const Vec3d from_axis = above_base - surface.axis * s;
    return dot(from_axis, from_axis) - surface.squared_radius(s);
}

// Two of Newton's steps along the gradient, which an apex has not: nearly there, by the shortest way.
template <class Quadric>
Vec3d nearly_on(const Quadric& quadric, Vec3d p) {
    for (int i = 0; i < 2; ++i) {
        const Vec3d g = gradient(quadric, p, Part::side);
        const double square = dot(g, g);
        if (square > 0) p -= g * (value(quadric, p) / square);
    }
    return p;
}

// The point is moved along its direction from the center.
Local on(const Ellipsoid& shape, const Vec3d& p) {
    const auto ellipsoid = in<double>(shape);
    const Vec3d f = (nearly_on(ellipsoid, p) - ellipsoid.center) / ellipsoid.radii;
    const double distance = glm::length(f), size = size_of(ellipsoid.center) + size_of(ellipsoid.radii);
    // Any point will do on an ellipsoid so small that rounding leaves no direction from its center.
    if (!(distance > 0)) return {ellipsoid.center + Vec3d{0, 0, ellipsoid.radii.z}, size, {0, 0, 1}};
    return {ellipsoid.center + ellipsoid.radii * (f / distance), size,
            scaled_to_largest_one(gradient(ellipsoid, p, Part::side))};
}

// The distance from the axis at s, from terms that do not cancel.
double radius_at(const Cylinder& c, double) { return c.radius; }
double radius_at(const Cone& c, double s) { return std::abs(c.base_radius * (1 - s) + c.top_radius * s); }
double radius_at(const Paraboloid& p, double s) { return p.radius * std::sqrt(std::max(s, 0.0)); }
double radius_at(const Hyperboloid& h, double s) {
    const double waist = h.waist, radius = h.radius, m = 2 * s - 1;
    return std::sqrt(std::max(waist * waist * (4 * s * (1 - s)) + radius * radius * (m * m), 0.0));
}

// An apex has no gradient; the axis points away from the cone there. Nor has the axis of what is so thin that rounding
// leaves no way from it: any direction across will do.
template <class Revolved>
Vec3d normal_of_side(const Revolved& shape, const Revolution<double>& surface, const Vec3d& p) {
    const Vec3d normal = gradient(surface, p, Part::side);
    if (normal != Vec3d(0)) return normal;
    if constexpr (std::same_as<Revolved, Cone>)
        return shape.base_radius < shape.top_radius ? -surface.axis : surface.axis;
    return cross(surface.axis, std::abs(surface.axis.x) < std::abs(surface.axis.y) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0});
}

// Straight away from the axis, where it is as far as the surface at this s. Rounding leaves the way a little oblique,
// which matters the more the longer it has to be made.
template <class Revolved>
Local on_side(const Revolved& shape, const Vec3d& p) {
    const Revolution<double> surface = in<double>(shape);
    const Vec3d above_base = nearly_on(surface, p) - surface.base;
    const double s = dot(above_base, surface.axis) / dot(surface.axis, surface.axis);
    const Vec3d spoke = above_base - surface.axis * s;
    const double radius = radius_at(shape, s), distance = glm::length(spoke);
    const double size = size_of(surface.base) + size_of(surface.axis) + size_of(above_base);
    const Vec3d foot = surface.base + surface.axis * s,
                normal = scaled_to_largest_one(normal_of_side(shape, surface, p));
    if (!(distance > 0)) return {foot, size + radius / rounding_error(1), normal};  // on the axis: an apex, or nearly
    return {foot + spoke * (radius / distance), size * std::max(1.0, radius / distance), normal};
}

struct OnShape {
    Vec3d point;  // near the surface, in the shape's own coordinates
    const Hit& hit;

    Local operator()(const Plane& plane) const { return on(SurfacePlane(plane), point); }
    Local operator()(const Disk& disk) const { return on(SurfacePlane(disk), point); }
    Local operator()(const Annulus& annulus) const { return on(SurfacePlane(annulus), point); }
    Local operator()(const Polygon& polygon) const { return on(SurfacePlane(polygon), point); }
    Local operator()(const Triangle& triangle) const { return on(triangle, hit); }
    Local operator()(const std::shared_ptr<const Mesh>& mesh) const {
        return on(mesh->triangle(hit.primitive.part), hit);
    }
    Local operator()(const Sphere& sphere) const { return on(sphere, point); }
    Local operator()(const Ellipsoid& ellipsoid) const { return on(ellipsoid, point); }
    template <class Shape>
    Local operator()(const Shape& shape) const {
        if (hit.part == Part::side) return on_side(shape, point);
        const Vec3d base = convert<double>(shape.base), top = convert<double>(shape.top);
        return on(hit.part == Part::base_cap ? SurfacePlane(base, base - top) : SurfacePlane(top, top - base), point);
    }
};

// The sizes of the numbers that a placement is made of: an entry that moves is a sum.
struct PlacementSize {
    double linear, translation;
};

PlacementSize size_of(const Affine& placement) {
    double linear = 0;
    for (const Vec3f& column : placement.columns) linear += size_of(convert<double>(column));
    return {linear, size_of(convert<double>(placement.translation))};
}

PlacementSize size_of(const Affine& placement, const Motion& motion, float time) {
    const PlacementSize begin = size_of(placement), rate = size_of(Affine{motion.columns, motion.translation});
    const double seconds = std::abs(double{time});
    return {begin.linear + seconds * rate.linear, begin.translation + seconds * rate.translation};
}

SurfacePosition placed_position(const TransformedRay<double>& local, const Hit& hit, const Shape& shape,
                                const PlacementAt<double>& placement, const PlacementSize& size) {
    const Local found = std::visit(OnShape{(local.origin + local.direction * hit.t) / local.scale, hit}, shape);
    const auto& [x, y, z] = placement.columns;
    const Vec3d& p = found.point;
    return {x * p.x + y * p.y + z * p.z + placement.translation,
            rounding_error(size.linear * found.size + size.translation),
            transformed_normal(placement.columns, found.normal)};
}

}  // namespace

SurfacePosition surface_position(const Ray& ray, const Hit& hit, const Shape& shape, const Affine& placement,
                                 const Motion* motion) {
    if (motion)
        return placed_position(transformed_ray<double>(ray, placement, *motion), hit, shape,
                               placement_at<double>(placement, *motion, ray.time),
                               size_of(placement, *motion, ray.time));
    if (placement.is_identity()) {
        const Vec3d near = convert<double>(ray.origin) + hit.t * convert<double>(ray.direction);
        if (const auto* sphere = std::get_if<Sphere>(&shape)) return PreparedSphere(*sphere).position(near);
        const Local found = std::visit(OnShape{near, hit}, shape);
        return {found.point, rounding_error(found.size), glm::normalize(found.normal)};
    }
    const AffineSteps at = AffineSteps::of(placement);
    return placed_position(transformed_ray<double>(ray, placement), hit, shape, {at.columns, at.translation},
                           size_of(placement));
}

}  // namespace raylab
