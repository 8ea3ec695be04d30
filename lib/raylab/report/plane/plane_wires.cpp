#include "raylab/report/plane/plane_view.h"

#include "raylab/geometry/perpendicular.h"

#include <cmath>
#include <numbers>

namespace raylab {

namespace {

constexpr int around = 48, levels = 16;  // as fine as a drawing can show

// A ring of points, in order.
using Ring = std::vector<Vec3d>;

Ring ring(const Vec3d& center, const Vec3d& u, const Vec3d& v) {
    Ring points;
    for (int i = 0; i < around; ++i) {
        const double angle = 2 * std::numbers::pi * i / around;
        points.push_back(center + u * std::cos(angle) + v * std::sin(angle));
    }
    return points;
}

Ring circle(const Vec3d& center, const Vec3d& axis, double radius) {
    const Vec3d u = perpendicular_to(axis), v = glm::normalize(cross(axis, u));
    return ring(center, u * radius, v * radius);
}

// Rings of points, with edges along each and between neighbouring ones.
Wires between(const std::vector<Ring>& rings) {
    Wires wires;
    for (std::size_t level = 0; level < rings.size(); ++level)
        for (std::size_t i = 0; i < rings[level].size(); ++i) {
            const std::size_t first = wires.points.size() - i, next = first + (i + 1) % rings[level].size();
            wires.edges.push_back({wires.points.size(), next});
            if (level > 0) wires.edges.push_back({wires.points.size(), wires.points.size() - rings[level - 1].size()});
            wires.points.push_back(rings[level][i]);
        }
    return wires;
}

// The rings of rho^2 = squared(s) about an axis from base to top (shapes.h).
template <class Squared>
std::vector<Ring> revolved(const Vec3f& base, const Vec3f& top, const Squared& squared) {
    const Vec3d from = convert<double>(base), axis = convert<double>(top) - from;
    std::vector<Ring> rings;
    for (int level = 0; level <= levels; ++level) {
        const double s = static_cast<double>(level) / levels;
        rings.push_back(circle(from + axis * s, axis, std::sqrt(std::max(0.0, squared(s)))));
    }
    return rings;
}

std::vector<Ring> ellipsoid(const Vec3d& center, const Vec3d& radii) {
    std::vector<Ring> rings;
    for (int level = 0; level <= levels; ++level) {
        const double angle = std::numbers::pi * level / levels, wide = std::sin(angle);
        rings.push_back(
            ring(center + Vec3d{0, 0, radii.z * std::cos(angle)}, {radii.x * wide, 0, 0}, {0, radii.y * wide, 0}));
    }
    return rings;
}

struct Wired {
    std::uint32_t part;

    std::vector<Wires> operator()(const Sphere& s) const {
        return {between(ellipsoid(convert<double>(s.center), Vec3d(double{s.radius})))};
    }
    std::vector<Wires> operator()(const Ellipsoid& e) const {
        return {between(ellipsoid(convert<double>(e.center), convert<double>(e.radii)))};
    }
    std::vector<Wires> operator()(const Cylinder& c) const {
        return {between(revolved(c.base, c.top, [&](double) { return double{c.radius} * c.radius; }))};
    }
    std::vector<Wires> operator()(const Cone& c) const {
        return {between(revolved(c.base, c.top, [&](double s) {
            const double radius = std::lerp(double{c.base_radius}, double{c.top_radius}, s);
            return radius * radius;
        }))};
    }
    std::vector<Wires> operator()(const Paraboloid& p) const {
        return {between(revolved(p.base, p.top, [&](double s) { return s * p.radius * p.radius; }))};
    }
    std::vector<Wires> operator()(const Hyperboloid& h) const {
        const auto rings = revolved(h.base, h.top, [&](double s) {
            const double waist = double{h.waist} * h.waist, rim = double{h.radius} * h.radius;
            return waist + (rim - waist) * (2 * s - 1) * (2 * s - 1);
        });
        std::vector<Wires> pieces;
        for (std::size_t i = 1; i < rings.size(); ++i) pieces.push_back(between({rings[i - 1], rings[i]}));
        return pieces;
    }
    std::vector<Wires> operator()(const Plane&) const { return {}; }
    std::vector<Wires> operator()(const Disk& d) const {
        return {between({circle(convert<double>(d.center), convert<double>(d.normal), d.radius)})};
    }
    // Not convex: in as many pieces as its rims have corners.
    std::vector<Wires> operator()(const Annulus& a) const {
        const Vec3d center = convert<double>(a.center), normal = convert<double>(a.normal);
        const Ring inner = circle(center, normal, a.inner_radius), outer = circle(center, normal, a.outer_radius);
        std::vector<Wires> pieces;
        for (std::size_t i = 0; i < outer.size(); ++i) {
            const std::size_t next = (i + 1) % outer.size();
            pieces.push_back(between({{inner[i], outer[i], outer[next], inner[next]}}));
        }
        return pieces;
    }
    std::vector<Wires> operator()(const Polygon& p) const {
        Ring corners;
        for (const Vec3f& vertex : p.vertices) corners.push_back(convert<double>(vertex));
        return {between({corners})};
    }
    std::vector<Wires> operator()(const Triangle& t) const {
        return {between({{convert<double>(t.a), convert<double>(t.b), convert<double>(t.c)}})};
    }
    std::vector<Wires> operator()(const std::shared_ptr<const Mesh>& mesh) const {
        return (*this)(mesh->triangle(part));
    }
};

}  // namespace

std::vector<Wires> wires_of(const Shape& shape, std::uint32_t part, const Affine& placement) {
    auto pieces = std::visit(Wired{part}, shape);
    for (Wires& piece : pieces)
        for (Vec3d& point : piece.points) point = transform_point(placement, point);
    return pieces;
}

}  // namespace raylab
