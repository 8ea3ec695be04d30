#include "raylab/radiosity/mesh/tessellation.h"

#include "raylab/geometry/part.h"
#include "raylab/geometry/perpendicular.h"
#include "raylab/geometry/quadric.h"
#include "raylab/radiosity/form_factor/convex_polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>

namespace raylab {

namespace {

using Corners = std::vector<Vec3d>;

constexpr int fewest_around = 12;

bool turns_left(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& normal) {
    return dot(cross(b - a, c - b), normal) > 0;
}

bool is_convex_polygon(const Corners& polygon) {
    const Vec3d normal = area_vector(polygon);
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i)
        if (!turns_left(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n], normal)) return false;
    return true;
}

bool lies_in(const Vec3d& point, const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& normal) {
    const auto beside = [&](const Vec3d& from, const Vec3d& to) {
        return dot(cross(to - from, point - from), normal) >= 0;
    };
    return beside(a, b) && beside(b, c) && beside(c, a);
}

bool is_ear(const Corners& polygon, std::size_t at, const Vec3d& normal) {
    const std::size_t n = polygon.size(), before = (at + n - 1) % n, behind = (at + 1) % n;
    if (!turns_left(polygon[before], polygon[at], polygon[behind], normal)) return false;
    for (std::size_t i = 0; i < n; ++i)
        if (i != before && i != at && i != behind &&
            lies_in(polygon[i], polygon[before], polygon[at], polygon[behind], normal))
            return false;
    return true;
}

// Equal for neighbouring triangles of one plane, whose corners were rounded to floats.
std::array<long long, 3> rounded_normal(const Corners& polygon) {
    const Vec3d normal = 1e4 * glm::normalize(area_vector(polygon));
    return {std::llround(normal.x), std::llround(normal.y), std::llround(normal.z)};
}

FlatPolygon one_piece(Corners corners, std::uint32_t part, std::uint32_t smooth) {
    return {corners, {{corners, part, smooth}}};
}

FlatPolygon polygon_of(const Corners& corners) {
    if (corners.size() <= 4 && is_convex_polygon(corners)) return one_piece(corners, 0, 0);
    FlatPolygon whole{corners, {}};
    for (auto& triangle : triangulated(corners)) whole.pieces.push_back({std::move(triangle), 0, 0});
    return whole;
}

int count_for(double length, double edge, int least) {
    constexpr double most = 1 << 16;  // piece_count() fits an integer; the caller refuses so many
    return std::max(least, static_cast<int>(std::min(std::ceil(length / edge - 1e-9), most)));
}

int count_around(double radius, double edge) { return count_for(2 * std::numbers::pi * radius, edge, fewest_around); }

/// How a ball is cut: rings at equal angles from pole to pole.
struct BallCut {
    BallCut(const Vec3d& radii, double edge)
        : largest(std::max({radii.x, radii.y, radii.z})),
          around(count_around(largest, edge)),
          bands((around + 1) / 2) {}
    double largest;
    int around, bands;
};

double radius_at(const Revolution<double>& shape, double s) {
    return std::sqrt(std::max(0.0, shape.squared_radius(s)));
}

/// How a surface of revolution is cut.
struct RevolutionCut {
    RevolutionCut(const Revolution<double>& shape, double edge)
        : widest(std::max({radius_at(shape, 0), radius_at(shape, 0.5), radius_at(shape, 1)})),
          straight(shape.q1 * shape.q1 == 4 * shape.q0 * shape.q2),
          around(count_around(widest, edge)),
          levels(straight ? 1 : count_for(std::hypot(glm::length(shape.axis), widest), edge, 4)) {}
    double widest;
    bool straight;  // rho is linear in s
    int around, levels;
};

/// Rings of equally many points about one axis; a ring of radius 0 is a pole.
struct Rings {
    Vec3d u, v;  // unit, and unit: they span the rings' planes, u x v along the axis
    int around;
    struct Ring {
        Vec3d center;
        double radius;
    };
    std::vector<Ring> rings;

    Vec3d point(const Ring& ring, int i) const {
        const double angle = 2 * std::numbers::pi * (i % around) / around;
        return ring.center + ring.radius * (std::cos(angle) * u + std::sin(angle) * v);
    }

    void add_band(const Ring& low, const Ring& high, std::vector<FlatPolygon>& to) const {
        for (int i = 0; i < around; ++i) {
            const Vec3d a = point(low, i), b = point(low, i + 1), c = point(high, i + 1), d = point(high, i);
            if (low.radius == 0 && high.radius == 0) continue;
            if (low.radius == 0)
                to.push_back(one_piece({a, c, d}, 0, 0));
            else if (high.radius == 0)
                to.push_back(one_piece({a, b, c}, 0, 0));
            else
                to.push_back(one_piece({a, b, c, d}, 0, 0));
        }
    }

    void add_bands(std::vector<FlatPolygon>& to) const {
        for (std::size_t i = 1; i < rings.size(); ++i) add_band(rings[i - 1], rings[i], to);
    }
};

// A flat ring about `axis`: one polygon if it has no hole, else a polygon for each sector.
void add_disk(const Vec3d& center, const Vec3d& axis, double inner, double outer, double edge, std::uint32_t part,
              std::vector<FlatPolygon>& to) {
    if (outer == 0) return;
    const Vec3d n = glm::normalize(axis), u = perpendicular_to(n);
    const Rings rings{u, cross(n, u), count_around(outer, edge), {}};
    FlatPolygon whole;
    for (int i = 0; i < rings.around; ++i) {
        const Vec3d a = rings.point({center, outer}, i), b = rings.point({center, outer}, i + 1);
        if (inner > 0) {
            to.push_back(
                one_piece({rings.point({center, inner}, i), a, b, rings.point({center, inner}, i + 1)}, part, part));
        } else {
            whole.corners.push_back(a);
            whole.pieces.push_back({{center, a, b}, part, part});
        }
    }
    if (inner == 0) to.push_back(std::move(whole));
}

// The distance of a chord from its arc.
double sagitta(double radius, double chord) {
    const double half = std::min(chord / 2, radius);
    return radius - std::sqrt(radius * radius - half * half);
}

struct Tessellated {
    double edge;

    Tessellation operator()(const Sphere& s) const {
        return ball(convert<double>(s.center), Vec3d(static_cast<double>(s.radius)));
    }
    Tessellation operator()(const Ellipsoid& e) const {
        return ball(convert<double>(e.center), convert<double>(e.radii));
    }
    Tessellation operator()(const Cylinder& c) const { return revolved(in<double>(c)); }
    Tessellation operator()(const Cone& c) const { return revolved(in<double>(c)); }
    Tessellation operator()(const Paraboloid& p) const { return revolved(in<double>(p)); }
    Tessellation operator()(const Hyperboloid& h) const { return revolved(in<double>(h)); }
    Tessellation operator()(const Plane&) const { return {}; }  // the caller refuses it
    Tessellation operator()(const Disk& d) const { return ring(d.center, d.normal, 0, d.radius); }
    Tessellation operator()(const Annulus& a) const { return ring(a.center, a.normal, a.inner_radius, a.outer_radius); }
    Tessellation operator()(const Polygon& p) const {
        Corners corners;
        for (const auto& vertex : p.vertices) corners.push_back(convert<double>(vertex));
        return {{polygon_of(corners)}};
    }
    Tessellation operator()(const Triangle& t) const {
        return {{one_piece({convert<double>(t.a), convert<double>(t.b), convert<double>(t.c)}, 0, 0)}};
    }
    // A mesh without normals has an edge wherever two of its planes meet: triangles of one plane are smooth together.
    Tessellation operator()(const std::shared_ptr<const Mesh>& mesh) const {
        Tessellation result;
        std::map<std::array<long long, 3>, std::uint32_t> first_with_normal;
        for (std::size_t face = 0; face < mesh->faces.size(); ++face) {
            const auto [a, b, c] = mesh->triangle(face);
            const auto part = static_cast<std::uint32_t>(face);
            result.polygons.push_back(
                one_piece({convert<double>(a), convert<double>(b), convert<double>(c)}, part, part));
            auto& piece = result.polygons.back().pieces[0];
            piece.smooth = mesh->normals.empty()
                               ? first_with_normal.try_emplace(rounded_normal(piece.corners), part).first->second
                               : 0;
        }
        return result;
    }

private:
    Tessellation ring(const Vec3f& center, const Vec3f& normal, double inner, double outer) const {
        Tessellation result;
        add_disk(convert<double>(center), convert<double>(normal), inner, outer, edge, 0, result.polygons);
        const int around = count_around(outer, edge);
        result.error = sagitta(outer, 2 * outer * std::sin(std::numbers::pi / around));
        return result;
    }

    // An ellipsoid is the image of the unit sphere, and planes stay planes.
    Tessellation ball(const Vec3d& center, const Vec3d& radii) const {
        const auto [largest, around, bands] = BallCut(radii, edge);
        Rings unit{{1, 0, 0}, {0, 1, 0}, around, {}};
        for (int i = 0; i <= bands; ++i) {
            const double angle = std::numbers::pi * (static_cast<double>(i) / bands - 0.5);
            unit.rings.push_back({{0, 0, std::sin(angle)}, i == 0 || i == bands ? 0 : std::cos(angle)});
        }
        Tessellation result;
        unit.add_bands(result.polygons);
        for (auto& polygon : result.polygons) {
            for (auto& corner : polygon.corners) corner = center + radii * corner;
            for (auto& piece : polygon.pieces)
                for (auto& corner : piece.corners) corner = center + radii * corner;
        }
        // A corner and the middle of a piece differ in both angles.
        const double step = 2 * std::sin(std::numbers::pi / around / 2), wide = 2 * std::sin(std::numbers::pi / around);
        result.error = largest * (sagitta(1, wide) + sagitta(1, 2 * step));
        return result;
    }

    // The largest distance between the profile and the chords of its rings, at eight points of each.
    template <class Radius>
    static double profile_error(const std::vector<Rings::Ring>& rings, const Revolution<double>& shape,
                                const Radius& radius) {
        const double squared_length = dot(shape.axis, shape.axis);
        const auto height = [&](const Rings::Ring& ring) {
            return dot(ring.center - shape.base, shape.axis) / squared_length;
        };
        double largest = 0;
        for (std::size_t i = 1; i < rings.size(); ++i)
            for (int k = 1; k < 9; ++k) {
                const double share = k / 9.0, s = glm::mix(height(rings[i - 1]), height(rings[i]), share);
                largest =
                    std::max(largest, std::abs(radius(s) - glm::mix(rings[i - 1].radius, rings[i].radius, share)));
            }
        return largest;
    }

    Tessellation revolved(const Revolution<double>& shape) const {
        const double length = glm::length(shape.axis);
        const Vec3d axis = shape.axis / length, u = perpendicular_to(axis);
        const auto radius = [&](double s) { return radius_at(shape, s); };
        const auto [widest, straight, around, levels] = RevolutionCut(shape, edge);
        Rings rings{u, cross(axis, u), around, {}};
        for (int i = 0; i <= levels; ++i) {
            // Squared where it begins at a vertex: the profile is steep there.
            const double share = static_cast<double>(i) / levels, s = shape.q0 == 0 ? share * share : share;
            rings.rings.push_back({shape.base + s * shape.axis, radius(s)});
        }
        Tessellation result;
        rings.add_bands(result.polygons);
        result.error = sagitta(widest, 2 * widest * std::sin(std::numbers::pi / around));
        if (!straight) result.error += profile_error(rings.rings, shape, radius);
        if (shape.ends == Ends::capped) {
            add_disk(shape.base, -axis, 0, radius(0), edge, static_cast<std::uint32_t>(Part::base_cap),
                     result.polygons);
            add_disk(shape.base + shape.axis, axis, 0, radius(1), edge, static_cast<std::uint32_t>(Part::top_cap),
                     result.polygons);
        }
        return result;
    }
};

struct Counted {
    double edge;

    std::size_t operator()(const Sphere& s) const { return ball(Vec3d(static_cast<double>(s.radius))); }
    std::size_t operator()(const Ellipsoid& e) const { return ball(convert<double>(e.radii)); }
    std::size_t operator()(const Cylinder& c) const { return revolved(in<double>(c)); }
    std::size_t operator()(const Cone& c) const { return revolved(in<double>(c)); }
    std::size_t operator()(const Paraboloid& p) const { return revolved(in<double>(p)); }
    std::size_t operator()(const Hyperboloid& h) const { return revolved(in<double>(h)); }
    std::size_t operator()(const Plane&) const { return 0; }
    std::size_t operator()(const Disk& d) const { return ring(d.radius); }
    std::size_t operator()(const Annulus& a) const { return ring(a.outer_radius); }
    std::size_t operator()(const Polygon& p) const { return p.vertices.size() <= 4 ? 1 : p.vertices.size() - 2; }
    std::size_t operator()(const Triangle&) const { return 1; }
    std::size_t operator()(const std::shared_ptr<const Mesh>& mesh) const { return mesh->faces.size(); }

private:
    static std::size_t product(int a, int b) { return static_cast<std::size_t>(a) * static_cast<std::size_t>(b); }
    std::size_t ring(float outer) const { return product(count_around(static_cast<double>(outer), edge), 1); }
    std::size_t ball(const Vec3d& radii) const {
        const BallCut cut(radii, edge);
        return product(cut.around, cut.bands);
    }
    std::size_t revolved(const Revolution<double>& shape) const {
        const RevolutionCut cut(shape, edge);
        return product(cut.around, cut.levels);
    }
};

}  // namespace

std::size_t piece_count(const Shape& shape, double edge) { return std::visit(Counted{edge}, shape); }

std::vector<std::vector<Vec3d>> triangulated(const std::vector<Vec3d>& polygon) {
    const Vec3d normal = area_vector(polygon);
    std::vector<Corners> triangles;
    Corners rest = polygon;
    while (rest.size() >= 3) {
        std::size_t ear = 0;
        while (ear < rest.size() && !is_ear(rest, ear, normal)) ++ear;
        if (ear == rest.size()) break;  // what is left has no area, or crosses itself
        const std::size_t n = rest.size();
        triangles.push_back({rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
}

Tessellation tessellation(const Shape& shape, double edge) { return std::visit(Tessellated{edge}, shape); }

}  // namespace raylab
