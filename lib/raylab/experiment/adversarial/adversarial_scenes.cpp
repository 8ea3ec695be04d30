#include "raylab/experiment/adversarial/adversarial_scenes.h"

#include "raylab/experiment/generate/loose_triangles.h"
#include "raylab/geometry/placement_at.h"
#include "raylab/number/dyadic.h"
#include "raylab/scene/check_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace raylab::adversarial {

Object object(Shape shape, const Affine& placement) { return {.shape = std::move(shape), .placement = placement}; }

Scene scene_of(const std::vector<Triangle>& triangles) {
    Scene scene;
    scene.objects.push_back(object(mesh_of(triangles)));
    return scene;
}

Affine any_placement(Draw& draw) {
    if (draw.one_in(3)) return {};
    Affine placement;
    do {
        for (Vec3f& column : placement.columns) column = draw.one_in(3) ? draw.on_lattice(-2, 2) : draw.in_cube(2);
    } while (is_singular(placement));
    placement.translation = draw.one_in(2) ? draw.on_lattice(-2, 2) : draw.in_cube(2);
    return placement;
}

Motion any_motion(Draw& draw) {
    const auto rate = [&](double most) { return draw.one_in(2) ? draw.on_lattice(-2, 2) : draw.in_cube(most); };
    Motion motion{.translation = rate(3)};
    if (draw.one_in(2)) return motion;
    for (Vec3f& column : motion.columns)
        if (draw.one_in(2)) column = rate(1);
    return motion;
}

float any_time(Draw& draw) {
    switch (draw.integer(0, 4)) {
        case 0:
            return cast<float>(draw.integer(0, 1));
        case 1:
            return cast<float>(draw.integer(1, 6)) / cast<float>(draw.integer(6, 7));
        case 2: {
            const int power = draw.integer(-140, 0);
            return std::ldexp(draw.uniform(0.5, 1), power);
        }
        default:
            return draw.uniform(0, 1);
    }
}

float any_time(Draw& draw, const Interval<float>& times) {
    const double time = std::lerp(double{times.min}, double{times.max}, double{any_time(draw)});
    return std::clamp(cast<float>(time), times.min, times.max);
}

bool is_singular_at(const Affine& placement, const Motion& motion, float time) {
    const auto [x, y, z] = placement_at<Dyadic>(placement, motion, time).columns;
    return sign(dot(x, cross(y, z))) == Sign::zero;
}

Vec3f any_point(Draw& draw) { return draw.one_in(2) ? draw.on_lattice(-3, 3) : draw.in_cube(3); }

float any_radius(Draw& draw) { return draw.one_in(2) ? cast<float>(draw.integer(1, 3)) : draw.uniform(0.1f, 2); }

namespace {

std::pair<Vec3f, Vec3f> any_axis(Draw& draw) {
    const Vec3f base = any_point(draw);
    return {base, base + (draw.one_in(2) ? draw.lattice_direction(2) : draw.in_cube(2) + Vec3f(0, 0, 3))};
}

Polygon any_polygon(Draw& draw) {
    const Vec3f center = any_point(draw), u = draw.lattice_direction(2), v = draw.in_cube(2);
    Polygon polygon;
    const int corners = draw.integer(3, 7);
    for (int i = 0; i < corners; ++i) {  // the polygon is not always convex, and now and then its edges cross
        const double angle = 6.28318530717958647692 * i / corners;
        const float reach = draw.uniform(0.3f, 1);
        polygon.vertices.push_back(center + u * (reach * cast<float>(std::cos(angle))) +
                                   v * (reach * cast<float>(std::sin(angle))));
    }
    if (draw.one_in(5)) std::swap(polygon.vertices[0], polygon.vertices[1]);
    return polygon;
}

Hyperboloid any_hyperboloid(Draw& draw, const Vec3f& base, const Vec3f& top, Ends ends) {
    const auto [waist, radius] = std::minmax({any_radius(draw), any_radius(draw)});
    return {base, top, waist, radius, ends};
}

Triangle any_triangle(Draw& draw) {
    for (;;) {
        const std::array corners{any_point(draw), any_point(draw), any_point(draw)};
        if (!spans_no_area(corners)) return {corners[0], corners[1], corners[2]};
    }
}

}  // namespace

Shape any_shape(Draw& draw) {
    const auto [base, top] = any_axis(draw);
    const Ends ends = draw.one_in(2) ? Ends::open : Ends::capped;
    switch (draw.integer(0, 9)) {
        case 0:
            return Sphere{any_point(draw), any_radius(draw)};
        case 1:
            return Ellipsoid{any_point(draw), {any_radius(draw), any_radius(draw), any_radius(draw)}};
        case 2:
            return Cylinder{base, top, any_radius(draw), ends};
        case 3:
            return Cone{base, top, draw.one_in(2) ? 0 : any_radius(draw), any_radius(draw), ends};
        case 4:
            return Paraboloid{base, top, any_radius(draw), ends};
        case 5:
            return any_hyperboloid(draw, base, top, ends);
        case 6:
            return Plane{any_point(draw),
                         draw.one_in(2) ? draw.lattice_direction(1) : draw.in_cube(1) + Vec3f(2, 0, 0)};
        case 7:
            return Disk{any_point(draw), draw.lattice_direction(2), any_radius(draw)};
        case 8:
            return any_polygon(draw);
        default:
            return any_triangle(draw);
    }
}

Annulus any_annulus(Draw& draw) {
    const Vec3f center = any_point(draw), normal = draw.lattice_direction(2);
    const float inner = any_radius(draw);
    const float outer = draw.one_in(4) ? std::nextafter(inner, 4.0f) : inner + any_radius(draw);
    return {center, normal, inner, outer};
}

Sides any_sides(Draw& draw) { return draw.one_in(2) ? Sides::both : draw.one_in(2) ? Sides::front : Sides::back; }

Object any_object(Draw& draw) {
    const Affine placement = any_placement(draw);
    Object result = object(any_shape(draw), placement);
    result.sides = any_sides(draw);
    return result;
}

Scene any_scene(Draw& draw, int objects) {
    Scene scene;
    for (int i = 0; i < objects; ++i) scene.objects.push_back(any_object(draw));
    return scene;
}

std::vector<Triangle> floor_of(int cells) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
            const auto at = [&](int x, int y) { return Vec3f(cast<float>(x), 1, cast<float>(y)); };
            triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            triangles.push_back({at(i + 1, j + 1), at(i, j + 1), at(i + 1, j)});
        }
    }
    return triangles;
}

std::vector<Triangle> soup(Draw& draw, std::size_t count, float half, const Vec3f& center) {
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3f a = center + draw.in_cube(half);
        triangles.push_back({a, a + draw.in_cube(half / 4), a + draw.in_cube(half / 4)});
    }
    return triangles;
}

}  // namespace raylab::adversarial
