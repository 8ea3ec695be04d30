#include "raylab/geometry/bounds/box.h"

#include "raylab/geometry/placement_at.h"
#include "raylab/geometry/predicate/flat_intersection.h"
#include "raylab/number/enclosure.h"
#include "raylab/number/next_float.h"

#include <algorithm>
#include <array>
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

// A placement as boxes see it: by the rows of its linear part.
struct Placed {
    std::array<Vec3<Enclosure>, 3> rows;
    Vec3<Enclosure> translation;
    bool is_identity = false;
};

Placed enclosed(const PlacementAt<Enclosure>& at) {
    const auto& [x, y, z] = at.columns;
    return {{{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}}, at.translation};
}

Placed enclosed(const Affine& m) {
    const auto& c = m.columns;
    Placed result = enclosed({{convert<Enclosure>(c[0]), convert<Enclosure>(c[1]), convert<Enclosure>(c[2])},
                              convert<Enclosure>(m.translation)});
    result.is_identity = m.is_identity();
    return result;
}

Placed enclosed(const Affine& m, const Motion& motion, float time) {
    return enclosed(placement_at<Enclosure>(m, motion, time));
}

Vec3<Enclosure> placed(const Placed& m, const Vec3<Enclosure>& p) {
    if (m.is_identity) return p;
    return {dot(m.rows[0], p) + m.translation.x, dot(m.rows[1], p) + m.translation.y,
            dot(m.rows[2], p) + m.translation.z};
}

// The box about a placed center that reaches as far along each world axis as reach(row of the linear part) says.
template <class Reach>
Box box_about(const Placed& m, const Vec3f& center, const Reach& reach) {
    const Vec3<Enclosure> c = placed(m, convert<Enclosure>(center));
    const Vec3<Enclosure> r{reach(m.rows[0]), reach(m.rows[1]), reach(m.rows[2])};
    return unite(box_of(c - r), box_of(c + r));
}

Enclosure length(const Vec3<Enclosure>& v) { return sqrt(dot(v, v)); }

// The image of a disk reaches radius |row x normal| / |normal| along an axis.
Box disk_box(const Placed& m, const Vec3f& center, const Vec3<Enclosure>& normal, float radius) {
    return box_about(m, center,
                     [&](const auto& row) { return Enclosure(radius) * length(cross(row, normal)) / length(normal); });
}

template <class S>
Box between_disks(const Placed& m, const S& shape, float base_radius, float top_radius) {
    const Vec3<Enclosure> axis = convert<Enclosure>(shape.top) - convert<Enclosure>(shape.base);
    return unite(disk_box(m, shape.base, axis, base_radius), disk_box(m, shape.top, axis, top_radius));
}

// A polygon lies in its exact plane, which its vertices may miss by a rounding: each is moved there along the axis that
// the definition projects along.
std::vector<Box> polygon_corners(const Placed& m, const Polygon& polygon) {
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

Box triangle_box(const Placed& m, const Triangle& t) {
    if (m.is_identity) return bounds(t);
    Box box;
    for (const Vec3f& v : {t.a, t.b, t.c}) box = unite(box, box_of(placed(m, convert<Enclosure>(v))));
    return box;
}

Box polygon_box(const Placed& m, const Polygon& polygon) {
    Box box;
    for (const Box& corner : polygon_corners(m, polygon)) box = unite(box, corner);
    return box;
}

struct Bounds {
    const Placed& m;

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
    Box operator()(const Triangle& t) const { return triangle_box(m, t); }
    Box operator()(const std::shared_ptr<const Mesh>& mesh) const {
        Box box;
        for (const Vec3f& v : mesh->vertices) box = unite(box, box_of(placed(m, convert<Enclosure>(v))));
        return box;
    }
    std::optional<Box> operator()(const Plane&) const { return std::nullopt; }
};

std::optional<Box> box_of(const Shape& shape, const Placed& m) {
    return std::visit([&](const auto& s) -> std::optional<Box> { return Bounds{m}(s); }, shape);
}

}  // namespace

Vec3d Box::center() const { return convert<double>(min) * 0.5 + convert<double>(max) * 0.5; }

std::vector<Box> corner_bounds(const Polygon& polygon, const Affine& placement) {
    return polygon_corners(enclosed(placement), polygon);
}

Box bounds(const Triangle& t) { return unite(unite({t.a, t.a}, {t.b, t.b}), {t.c, t.c}); }

Box bounds(const Triangle& t, const Affine& placement) { return triangle_box(enclosed(placement), t); }

Box bounds(const Triangle& t, const Affine& placement, const Motion& motion, float time) {
    return triangle_box(enclosed(placement, motion, time), t);
}

std::optional<Box> bounds(const Shape& shape, const Affine& placement) { return box_of(shape, enclosed(placement)); }

std::optional<Box> bounds(const Shape& shape, const Affine& placement, const Motion& motion, float time) {
    return box_of(shape, enclosed(placement, motion, time));
}

}  // namespace raylab
