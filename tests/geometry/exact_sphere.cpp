#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/experiment/adversarial/adversarial.h"

using namespace raylab;
using namespace raylab::adversarial;
using raylab::adversarial::Draw;

namespace {

struct Case {
    Ray ray;
    Sphere sphere;
};

Vec3d direction(Draw& draw) {
    const Vec3d d = convert<double>(draw.in_cube(1));
    const double length = glm::length(d);
    return length > 0.01 ? d / length : Vec3d(1, 0, 0);
}

// Through a point at `distance` radii from the center, seen from `origin`: 1 is the silhouette.
Case aimed(Draw& draw, const Vec3f& origin, const Sphere& sphere, double distance) {
    const Vec3d center = convert<double>(sphere.center);
    const Vec3d to_center = glm::normalize(center - convert<double>(origin));
    const Vec3d aside = glm::normalize(cross(to_center, direction(draw)));
    return {through(origin, center + aside * (distance * sphere.radius)), sphere};
}

Sphere any_sphere(Draw& draw) { return {draw.in_cube(1), draw.uniform(0.1, 1)}; }

Case generic(Draw& draw) { return aimed(draw, draw.in_cube(4), any_sphere(draw), draw.number(0, 1.2)); }

Case silhouette(Draw& draw) { return aimed(draw, draw.in_cube(100), any_sphere(draw), 1 + draw.number(-1e-7, 1e-7)); }

Case from_afar(Draw& draw) { return aimed(draw, draw.in_cube(1e5), any_sphere(draw), draw.number(0, 1.001)); }

Case center_shot(Draw& draw) { return aimed(draw, draw.in_cube(1e3), any_sphere(draw), 0); }

Case on_surface(Draw& draw) {
    const Sphere sphere = any_sphere(draw);
    const Vec3d point = convert<double>(sphere.center) + direction(draw) * double{sphere.radius};
    return {{convert<float>(point), convert<float>(direction(draw))}, sphere};
}

// A floor: the origin a little above a sphere of radius 1e5 or 1e7, in any direction (an axis-parallel one is luck).
Case above_floor(Draw& draw) {
    const Sphere sphere{draw.in_cube(1e3), draw.one_in(2) ? 1e5f : 1e7f};
    const Vec3d point = convert<double>(sphere.center) + direction(draw) * (sphere.radius + draw.number(0, 2));
    return {{convert<float>(point), convert<float>(direction(draw))}, sphere};
}

template <int decimal_exponent>
Case at_scale(Draw& draw) {
    const float scale = cast<float>(std::pow(10.0, decimal_exponent));
    Case c = draw.one_in(2) ? silhouette(draw) : generic(draw);
    for (Vec3f* p : {&c.ray.origin, &c.ray.direction, &c.sphere.center}) *p = scaled(*p, scale);
    c.sphere.radius *= scale;
    return c;
}

// Integer coordinates: exact tangents, exact hits at t = 1, origins on the surface.
Case lattice(Draw& draw) {
    return {{draw.on_lattice(-5, 5), draw.lattice_direction(3)},
            {draw.on_lattice(-3, 3), cast<float>(draw.integer(0, 5))}};
}

// Axis-parallel at exactly the radius from the center.
Case tangent(Draw& draw) {
    const Sphere sphere{scaled(draw.on_lattice(-64, 64), 1.0f / 16), cast<float>(draw.integer(1, 64)) / 16};
    Vec3f origin = sphere.center;
    const int axis = draw.integer(0, 2), along = (axis + 1) % 3;
    origin[axis] += sphere.radius;
    origin[along] += cast<float>(draw.integer(-64, 64)) / 8;
    Vec3f d(0);
    d[along] = draw.uniform(0.1, 1);
    return {{origin, d}, sphere};
}

Case whole_range(Draw& draw) {
    const Sphere sphere{draw.anywhere(), std::abs(draw.anything())};
    const Vec3f origin = draw.one_in(2) ? draw.anywhere() : sphere.center;
    return {{origin, draw.any_direction()}, sphere};
}

}  // namespace

TEST_CASE("ray against sphere: every decision is the exact one, and t within one float of exact") {
    const auto make = GENERATE(generic, silhouette, from_afar, center_shot, on_surface, above_floor, at_scale<-15>,
                               at_scale<13>, at_scale<-38>, at_scale<34>, lattice, tangent, whole_range);
    const auto judge = [&](Draw& draw) {
        const auto [ray, sphere] = make(draw);
        return fault_in_ranges(draw, ray, sphere);
    };
    CHECK(faults(77'000, judge) == "");
}
