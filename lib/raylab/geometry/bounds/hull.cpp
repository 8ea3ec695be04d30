#include "raylab/geometry/bounds/hull.h"

#include "raylab/geometry/largest_coordinate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

// A point's exact place lies in a box rounded outward.
Ball ball_around(const Box& box) {
    const Vec3d half = convert<double>(box.max) * 0.5 - convert<double>(box.min) * 0.5;
    return {box.center(), half.x + half.y + half.z};
}

Ball placed(const Vec3f& vertex, const Affine& placement) {
    if (placement.is_identity()) return {convert<double>(vertex), 0};
    return ball_around(bounds(Triangle{vertex, vertex, vertex}, placement));
}

double sum_of_sizes(const Vec3d& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

// A point computed in doubles on the way to its place: so many of its roundings are made good that all of them are.
Ball placed_roughly(const Vec3d& point, double sizes, const Affine& m) {
    double terms = sum_of_sizes(convert<double>(m.translation));
    for (const Vec3f& column : m.columns) terms += sum_of_sizes(convert<double>(column)) * sizes;
    return {transform_point(m, point), 32 * unit_roundoff<double> * terms};
}

void add_disk(Hull& hull, const Vec3f& center, const Vec3d& normal, double radius, const Affine& m) {
    // The numbers of a 16-gon around the circle: 1 / cos 11.25 degrees, and the cosines of 22.5, 45 and 67.5, all a
    // little larger.
    constexpr double around = 1.0197, c1 = 0.92389, c2 = 0.70711, c3 = 0.38269;
    constexpr std::array<std::array<double, 2>, 4> quarter{{{1, 0}, {c1, c3}, {c2, c2}, {c3, c1}}};
    const Vec3d n = normal / largest_coordinate(normal);
    const Vec3d aside = std::abs(n.x) < std::abs(n.y) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d u = glm::normalize(cross(n, aside)), v = glm::normalize(cross(n, u));
    const Vec3d c = convert<double>(center);
    const auto add = [&](double x, double y) {
        const Vec3d corner = c + (u * x + v * y) * (around * radius);
        hull.push_back(placed_roughly(corner, sum_of_sizes(c) + 4 * radius, m));
    };
    for (const auto& [x, y] : quarter) {
        add(x, y);
        add(-y, x);
        add(-x, -y);
        add(y, -x);
    }
}

// An ellipsoid in the parallelepiped that its box before it was placed becomes; one that is nearly round in a ball.
Hull around_ellipsoid(const Vec3f& center, const Vec3d& radii, const Affine& m) {
    std::array<Vec3d, 3> half{};
    for (std::size_t i = 0; i < 3; ++i) half[i] = convert<double>(m.columns[i]) * radii[static_cast<int>(i)];
    double stretch =
        0;  // of the unit sphere: no row of the symmetric product adds up to less than its largest eigenvalue
    for (const Vec3d& a : half)
        stretch = std::max(stretch, std::abs(dot(a, half[0])) + std::abs(dot(a, half[1])) + std::abs(dot(a, half[2])));
    const double radius = std::sqrt(stretch) * (1 + 0x1p-40), volume = std::abs(dot(half[0], cross(half[1], half[2])));
    const Ball middle = placed_roughly(convert<double>(center), sum_of_sizes(convert<double>(center)), m);
    if (radius * radius * radius < 2 * volume) return {{middle.center, middle.radius + radius}};
    Hull hull;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0})
                hull.push_back({middle.center + half[0] * x + half[1] * y + half[2] * z,
                                middle.radius + 0x1p-40 * (sum_of_sizes(middle.center) + radius)});
    return hull;
}

struct HullOf {
    const Affine& m;

    template <class S>
    Hull between(const S& shape, double base_radius, double top_radius) const {
        const Vec3d axis = convert<double>(shape.top) - convert<double>(shape.base);
        Hull hull;
        add_disk(hull, shape.base, axis, base_radius, m);
        add_disk(hull, shape.top, axis, top_radius, m);
        return hull;
    }

    Hull operator()(const Sphere& s) const {
        if (m.is_identity()) return {{convert<double>(s.center), s.radius}};
        return around_ellipsoid(s.center, Vec3d(s.radius), m);
    }
    Hull operator()(const Ellipsoid& e) const { return around_ellipsoid(e.center, convert<double>(e.radii), m); }
    Hull operator()(const Cylinder& c) const { return between(c, c.radius, c.radius); }
    Hull operator()(const Cone& c) const { return between(c, c.base_radius, c.top_radius); }
    // sqrt(s) <= (1 + s) / 2: it bulges no further than the cone that touches it at its rim.
    Hull operator()(const Paraboloid& p) const { return between(p, p.radius / 2.0, p.radius); }
    Hull operator()(const Hyperboloid& h) const {
        return between(h, std::max(h.waist, h.radius), std::max(h.waist, h.radius));
    }
    Hull operator()(const Disk& d) const {
        Hull hull;
        add_disk(hull, d.center, convert<double>(d.normal), d.radius, m);
        return hull;
    }
    Hull operator()(const Annulus& a) const {
        Hull hull;
        add_disk(hull, a.center, convert<double>(a.normal), a.outer_radius, m);
        return hull;
    }
    Hull operator()(const Polygon& p) const {
        Hull hull;
        for (const Box& corner : corner_bounds(p, m)) hull.push_back(ball_around(corner));
        return hull;
    }
    Hull operator()(const Triangle& t) const { return raylab::hull(t, m); }
    Hull operator()(const std::shared_ptr<const Mesh>& mesh) const {
        Hull hull;
        for (const Vec3f& vertex : mesh->vertices) hull.push_back(placed(vertex, m));
        return hull;
    }
    Hull operator()(const Plane&) const { return {}; }
};

}  // namespace

Hull hull(const Triangle& t, const Affine& placement) {
    return {placed(t.a, placement), placed(t.b, placement), placed(t.c, placement)};
}

Hull hull(const Shape& shape, const Affine& placement) {
    Hull balls = std::visit(HullOf{placement}, shape);
    if (is_finite(balls)) return balls;
    // Something was too large or no number (a normal of zero): the box knows what to do.
    return hull(*bounds(shape, placement));
}

Hull hull(const Box& box) {
    Hull corners;
    for (int corner = 0; corner < 8; ++corner) {
        const auto at = [&](int axis) { return double{(corner >> axis & 1) != 0 ? box.max[axis] : box.min[axis]}; };
        corners.push_back({{at(0), at(1), at(2)}, 0});
    }
    return corners;
}

Hull swept(const Hull& at_rest, const Vec3f& velocity, const Interval<float>& times) {
    Hull both;
    for (const float time : {times.min, times.max})
        for (const Ball& ball : at_rest) {
            const Vec3d center = ball.center + double{time} * convert<double>(velocity);
            // The product is exact; three sums are rounded once each, and so is this one.
            both.push_back({center, ball.radius + 4 * unit_roundoff<double> * (sum_of_sizes(center) + ball.radius)});
        }
    return both;
}

bool is_finite(std::span<const Ball> hull) {
    const auto is_near = [](double x) { return std::abs(x) <= 0x1p126; };
    return std::ranges::all_of(hull, [&](const Ball& ball) {
        return is_near(ball.center.x) && is_near(ball.center.y) && is_near(ball.center.z) && is_near(ball.radius);
    });
}

Hull extremes(std::span<const Ball> balls) {
    constexpr std::array<Vec3d, 7> directions{
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}}};
    Hull result;
    for (const Vec3d& direction : directions) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        const Ball *lowest = nullptr, *highest = nullptr;
        const double length = direction.y == 0 || direction.x == 0 ? 1 : std::sqrt(3.0);
        for (const Ball& ball : balls) {
            const double along = dot(direction, ball.center), reach = length * ball.radius;
            if (along - reach < low) {
                low = along - reach;
                lowest = &ball;
            }
            if (along + reach > high) {
                high = along + reach;
                highest = &ball;
            }
        }
        if (lowest && highest) result.insert(result.end(), {*lowest, *highest});
    }
    return result;
}

}  // namespace raylab
