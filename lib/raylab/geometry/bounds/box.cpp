#include "raylab/geometry/bounds/box.h"

#include "raylab/geometry/predicate/flat_intersection.h"
#include "raylab/number/enclosure.h"
#include "raylab/number/next_float.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// An Enclosure that an overflow has made unknown bounds nothing.
float upper(const Enclosure& x) { return std::isnan(x.upper()) ? infinity : rounded_up(x.upper()); }
float lower(const Enclosure& x) { return -upper(-x); }

Box box_of(const Vec3<Enclosure>& p) {
    return {{lower(p.x), lower(p.y), lower(p.z)}, {upper(p.x), upper(p.y), upper(p.z)}};
}

Vec3<Enclosure> row(const Affine& m, int i) {
    return {Enclosure(m.columns[0][i]), Enclosure(m.columns[1][i]), Enclosure(m.columns[2][i])};
}

Vec3<Enclosure> placed(const Affine& m, const Vec3<Enclosure>& p) {
    if (m.is_identity()) return p;
    const auto along = [&](int i) { return dot(row(m, i), p) + Enclosure(m.translation[i]); };
    return {along(0), along(1), along(2)};
}

// The box about a placed center that reaches as far along each world axis as reach(row of the linear part) says.
template <class Reach>
Box box_about(const Affine& m, const Vec3f& center, const Reach& reach) {
    const Vec3<Enclosure> c = placed(m, convert<Enclosure>(center));
    const Vec3<Enclosure> r{reach(row(m, 0)), reach(row(m, 1)), reach(row(m, 2))};
    return unite(box_of(c - r), box_of(c + r));
}

Enclosure length(const Vec3<Enclosure>& v) { return sqrt(dot(v, v)); }

// The image of a disk reaches radius |row x normal| / |normal| along an axis.
Box disk_box(const Affine& m, const Vec3f& center, const Vec3<Enclosure>& normal, float radius) {
    return box_about(m, center,
                     [&](const auto& row) { return Enclosure(radius) * length(cross(row, normal)) / length(normal); });
}

template <class S>
Box between_disks(const Affine& m, const S& shape, float base_radius, float top_radius) {
    const Vec3<Enclosure> axis = convert<Enclosure>(shape.top) - convert<Enclosure>(shape.base);
    return unite(disk_box(m, shape.base, axis, base_radius), disk_box(m, shape.top, axis, top_radius));
}

Box polygon_box(const Affine& m, const Polygon& polygon) {
    Box box;
    for (const Box& corner : corner_bounds(polygon, m)) box = unite(box, corner);
    return box;
}

struct Bounds {
    const Affine& m;

    Box operator()(const Sphere& s) const {
        return box_about(m, s.center, [&](const auto& row) { return Enclosure(s.radius) * length(row); });
    }
    Box operator()(const Ellipsoid& e) const {
        return box_about(m, e.center, [&](const Vec3<Enclosure>& row) {
            const auto& r = e.radii;
            return length({row.x * Enclosure(r.x), row.y * Enclosure(r.y), row.z * Enclosure(r.z)});
        });
    }
    Box operator()(const Cylinder& c) const { return between_disks(m, c, c.radius, c.radius); }
    Box operator()(const Cone& c) const { return between_disks(m, c, c.base_radius, c.top_radius); }
    // It bulges beyond the hull of its vertex and its rim, not beyond the cylinder on its rim.
    Box operator()(const Paraboloid& p) const { return between_disks(m, p, p.radius, p.radius); }
    Box operator()(const Hyperboloid& h) const {
        const float widest = std::max(h.waist, h.radius);
        return between_disks(m, h, widest, widest);
    }
    Box operator()(const Disk& d) const { return disk_box(m, d.center, convert<Enclosure>(d.normal), d.radius); }
    Box operator()(const Annulus& a) const {
        return disk_box(m, a.center, convert<Enclosure>(a.normal), a.outer_radius);
    }
    Box operator()(const Polygon& p) const { return polygon_box(m, p); }
    Box operator()(const Triangle& t) const { return bounds(t, m); }
    Box operator()(const std::shared_ptr<const Mesh>& mesh) const {
        Box box;
        for (const Vec3f& v : mesh->vertices) box = unite(box, box_of(placed(m, convert<Enclosure>(v))));
        return box;
    }
    std::optional<Box> operator()(const Plane&) const { return std::nullopt; }
};

}  // namespace

Vec3d Box::center() const { return convert<double>(min) * 0.5 + convert<double>(max) * 0.5; }

// A polygon lies in its exact plane, which its vertices may miss by a rounding: each is moved there along the axis that
// the definition projects along.
std::vector<Box> corner_bounds(const Polygon& polygon, const Affine& m) {
    Signs<Dyadic> signs;
    const Vec3<Dyadic> exact = newell_normal<Dyadic>(polygon);
    const int axis = static_cast<int>(dominant_axis(exact, signs));
    const auto rounded = [](const Dyadic& x) {
        const double nearest = quotient(x, Dyadic(1));
        return Enclosure(nearest, std::abs(nearest) * std::numeric_limits<double>::epsilon() +
                                      std::numeric_limits<double>::denorm_min());
    };
    const Vec3<Enclosure> normal{rounded(exact.x), rounded(exact.y), rounded(exact.z)};
    const Vec3<Enclosure> first = convert<Enclosure>(polygon.vertices.front());
    std::vector<Box> corners;
    for (const Vec3f& vertex : polygon.vertices) {
        Vec3<Enclosure> p = convert<Enclosure>(vertex);
        const Enclosure height = dot(normal, p - first);
        if (axis == 0) p.x = p.x - height / normal.x;
        if (axis == 1) p.y = p.y - height / normal.y;
        if (axis == 2) p.z = p.z - height / normal.z;
        corners.push_back(box_of(placed(m, p)));
    }
    return corners;
}

Box bounds(const Triangle& t) { return unite(unite({t.a, t.a}, {t.b, t.b}), {t.c, t.c}); }

Box bounds(const Triangle& t, const Affine& placement) {
    if (placement.is_identity()) return bounds(t);
    Box box;
    for (const Vec3f& v : {t.a, t.b, t.c}) box = unite(box, box_of(placed(placement, convert<Enclosure>(v))));
    return box;
}

std::optional<Box> bounds(const Shape& shape, const Affine& placement) {
    return std::visit([&](const auto& s) -> std::optional<Box> { return Bounds{placement}(s); }, shape);
}

}  // namespace raylab
