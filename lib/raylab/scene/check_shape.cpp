#include "raylab/scene/check_shape.h"

#include "raylab/geometry/placement_at.h"
#include "raylab/geometry/singular_motion.h"

#include <fmt/format.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab {

namespace {

template <Scalar T>
struct Newell {
    Triple<T> normal{T(0), T(0), T(0)};
    T magnitude = T(0);  // the sum of the absolute values of the products that were added
};

template <Scalar T>
Newell<T> newell(std::span<const Vec3f> vertices) {
    const auto in = [](const Vec3f& v) { return Triple<T>{T(v.x), T(v.y), T(v.z)}; };
    Newell<T> result;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto a = in(vertices[i]);
        const auto b = in(vertices[(i + 1) % vertices.size()]);
        result.normal = result.normal + cross(a, b);
        const std::array<T, 6> products{a.y * b.z, a.z * b.y, a.z * b.x, a.x * b.z, a.x * b.y, a.y * b.x};
        for (const T& product : products) result.magnitude += product < 0 ? T(-product) : product;
    }
    return result;
}

// Whether the sum is too large to be rounding error alone: products of floats are exact in double, and each of the 2n
// additions errs by at most 2^-53 of the magnitude so far.
bool surely_spans_area(std::span<const Vec3f> vertices) {
    const auto sum = newell<double>(vertices);
    const double error = 4 * static_cast<double>(vertices.size()) * unit_roundoff<double> * sum.magnitude;
    return std::abs(sum.normal.x) > error || std::abs(sum.normal.y) > error || std::abs(sum.normal.z) > error;
}

class ShapeCheck {
public:
    explicit ShapeCheck(const Place& place) : place_(place) {}

    void operator()(const Sphere& sphere) const { positive(sphere.radius, "radius"); }
    void operator()(const Ellipsoid& ellipsoid) const {
        for (const float radius : {ellipsoid.radii.x, ellipsoid.radii.y, ellipsoid.radii.z}) positive(radius, "radius");
    }
    void operator()(const Cylinder& cylinder) const {
        axis(cylinder.base, cylinder.top);
        positive(cylinder.radius, "radius");
    }
    void operator()(const Cone& cone) const {
        axis(cone.base, cone.top);
        for (const float radius : {cone.base_radius, cone.top_radius})
            if (!(radius >= 0)) refuse("a radius of at least 0", fmt::format("{}", radius));
        if (cone.base_radius == 0 && cone.top_radius == 0) refuse("a cone with a radius above 0", "0 at both ends");
    }
    void operator()(const Paraboloid& paraboloid) const {
        axis(paraboloid.base, paraboloid.top);
        positive(paraboloid.radius, "radius");
    }
    void operator()(const Hyperboloid& hyperboloid) const {
        axis(hyperboloid.base, hyperboloid.top);
        positive(hyperboloid.waist, "waist");
        if (!(hyperboloid.radius >= hyperboloid.waist))
            refuse("a hyperboloid at least as wide at its ends as at its waist",
                   fmt::format("radius {} and waist {}", hyperboloid.radius, hyperboloid.waist));
    }
    void operator()(const Plane& plane) const { normal(plane.normal); }
    void operator()(const Disk& disk) const {
        normal(disk.normal);
        positive(disk.radius, "radius");
    }
    void operator()(const Annulus& annulus) const {
        normal(annulus.normal);
        positive(annulus.inner_radius, "inner radius");
        if (!(annulus.outer_radius > annulus.inner_radius))
            refuse("an annulus whose outer radius is above its inner radius",
                   fmt::format("outer_radius {} and inner_radius {}", annulus.outer_radius, annulus.inner_radius));
    }
    void operator()(const Polygon& polygon) const { area(polygon.vertices, "a polygon"); }
    void operator()(const Triangle& triangle) const {
        area(std::array{triangle.a, triangle.b, triangle.c}, "a triangle");
    }
    void operator()(const std::shared_ptr<const Mesh>&) const {}  // the mesh's reader has checked it

private:
    void positive(float size, const char* name) const {
        if (!(size > 0)) refuse(fmt::format("a {} above 0", name), fmt::format("{}", size));
    }
    void axis(const Vec3f& base, const Vec3f& top) const {
        if (base == top) refuse("an axis whose base and top differ", in_words(base) + " for both");
    }
    void normal(const Vec3f& normal) const {
        if (normal == Vec3f{0, 0, 0}) refuse("a normal that is not zero", in_words(normal));
    }
    void area(std::span<const Vec3f> vertices, const std::string& what) const {
        if (spans_no_area(vertices)) refuse(what + " with an area", "vertices on one line");
    }

    [[noreturn]] void refuse(const std::string& expected, const std::string& found) const {
        throw Error(place_, expected, found);
    }
    static std::string in_words(const Vec3f& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

    const Place& place_;
};

// Of a placement, or of a motion.
template <class Map>
bool fits_floats(const Map& map) {
    const auto& c = map.columns;
    return std::ranges::all_of(std::array{c[0], c[1], c[2], map.translation}, [](const Vec3f& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    });
}

bool fits_floats(const Interval<float>& times) { return std::isfinite(times.min) && std::isfinite(times.max); }

}  // namespace

void check_shape(const Shape& shape, const Place& place) { std::visit(ShapeCheck(place), shape); }

void check_placement(const Affine& placement, const Place& place) {
    if (placement.is_identity()) return;
    if (!fits_floats(placement)) throw Error(place, "transforms whose product fits floats", "one that overflows");
    if (is_singular(placement))
        throw Error(place, "a transform that can be undone", "one that flattens (determinant 0)");
}

void check_motion(const Affine& placement, const Motion& motion, const Interval<float>& times, const Place& place) {
    if (!fits_floats(motion)) throw Error(place, "a motion that fits floats", "one that overflows");
    if (!fits_floats(times)) throw Error(place, "a motion between finite times", "a shutter that overflows");
    if (only_translates(motion)) return;  // the determinant stays what it is
    if (is_singular_during(placement, motion, times))
        throw Error(place,
                    fmt::format("a transform that can be undone at all times from {} to {}", times.min, times.max),
                    "one that flattens (determinant 0) on its way");
}

bool spans_no_area(std::span<const Vec3f> vertices) {
    if (surely_spans_area(vertices)) return false;
    const auto exact = newell<mpq_class>(vertices).normal;
    return sgn(exact.x) == 0 && sgn(exact.y) == 0 && sgn(exact.z) == 0;
}

}  // namespace raylab
