#include "raylab/geometry/surface_position.h"

#include "raylab/geometry/gradient.h"
#include "raylab/geometry/local_ray.h"
#include "raylab/geometry/meet_flat.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

namespace raylab {

namespace {

// A point is computed in a few dozen rounded operations on numbers no larger than `size`; each costs half a unit.
constexpr double roundings = 64;
double rounding_error(double size) { return roundings * unit_roundoff<double> * size; }

double size_of(const Vec3d& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

// A point in the shape's own coordinates and how large the numbers were that it was made of.
struct Local {
    Vec3d point;
    double size;
};

Local on(const Triangle& triangle, const Hit& hit) {
    const Vec3d a = convert<double>(triangle.a), b = convert<double>(triangle.b), c = convert<double>(triangle.c);
    return {a * (1 - hit.u - hit.v) + b * hit.u + c * hit.v, size_of(a) + size_of(b) + size_of(c)};
}

// The foot of the perpendicular from p on the plane through q.
Local on_plane(const Vec3d& p, const Vec3d& q, const Vec3d& normal) {
    const double size = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    const Vec3d n = normal / size;  // lengths are squared, and floats' lengths may be 1e38
    return {p - n * (dot(p - q, n) / dot(n, n)), size_of(p) + size_of(q)};
}

Local on(const Sphere& sphere, const Vec3d& p) {
    const Vec3d center = convert<double>(sphere.center);
    const double distance = glm::length(p - center);
    const double r = sphere.radius;
    return {distance > 0 ? center + (p - center) * (r / distance) : p, size_of(center) + r};
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

// One of Newton's steps along the gradient; an apex has none.
template <class Quadric>
Vec3d step(const Quadric& quadric, const Vec3d& p, Part part) {
    const Vec3d g = gradient(quadric, p, part);
    const double square = dot(g, g);
    return square > 0 ? p - g * (value(quadric, p) / square) : p;
}

struct OnShape {
    Vec3d point;  // near the surface, in the shape's own coordinates
    const Hit& hit;

    Part part() const { return static_cast<Part>(static_cast<int>(hit.u)); }

    Local operator()(const Plane& plane) const {
        return on_plane(point, convert<double>(plane.point), convert<double>(plane.normal));
    }
    Local operator()(const Disk& disk) const {
        return on_plane(point, convert<double>(disk.center), convert<double>(disk.normal));
    }
    Local operator()(const Polygon& polygon) const {
        return on_plane(point, convert<double>(polygon.vertices.front()), newell_normal<double>(polygon));
    }
    Local operator()(const Triangle& triangle) const { return on(triangle, hit); }
    Local operator()(const std::shared_ptr<const Mesh>& mesh) const { return on(mesh->triangle(hit.primitive.part), hit); }
    Local operator()(const Sphere& sphere) const { return on(sphere, point); }
    Local operator()(const Ellipsoid& shape) const {
        const auto ellipsoid = in<double>(shape);
        const Vec3d p = step(ellipsoid, step(ellipsoid, point, Part::side), Part::side);
        const double widest = std::max({ellipsoid.radii.x, ellipsoid.radii.y, ellipsoid.radii.z});
        const double thinnest = std::min({ellipsoid.radii.x, ellipsoid.radii.y, ellipsoid.radii.z});
        return {p, size_of(ellipsoid.center) * (widest / thinnest) + widest};
    }
    template <class Shape>
    Local operator()(const Shape& shape) const {
        const Revolution<double> surface = in<double>(shape);
        const double size = size_of(surface.base) + size_of(surface.axis) + size_of(point);
        if (part() == Part::base_cap) return {on_plane(point, surface.base, surface.axis).point, size};
        if (part() == Part::top_cap) return {on_plane(point, surface.base + surface.axis, surface.axis).point, size};
        return {step(surface, step(surface, point, Part::side), Part::side), size};
    }
};

}  // namespace

SurfacePosition surface_position(const Ray& ray, const Hit& hit, const Shape& shape, const Affine& placement) {
    if (placement.is_identity()) {
        const Vec3d near = convert<double>(ray.origin) + hit.t * convert<double>(ray.direction);
        const Local found = std::visit(OnShape{near, hit}, shape);
        return {found.point, rounding_error(found.size)};
    }
    const LocalRay<double> local = local_ray<double>(ray, placement);
    const Local found = std::visit(OnShape{(local.origin + local.direction * hit.t) / local.scale, hit}, shape);
    double stretch = 0;
    for (const Vec3f& column : placement.columns) stretch += size_of(convert<double>(column));
    return {transform_point(placement, found.point),
            rounding_error(stretch * found.size + size_of(convert<double>(placement.translation)))};
}

}  // namespace raylab
