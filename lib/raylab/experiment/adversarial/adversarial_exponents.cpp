#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/generate/loose_triangles.h"

#include <cmath>
#include <memory>
#include <utility>

namespace raylab::adversarial {

namespace {

// Sizes reach from the smallest normal float to 2^100: the cube of the largest is still a double, and so are all error
// bounds.
constexpr int smallest_power = -126, largest_power = 100;
constexpr int placement_power = 40;  // entries of transforms reach from 2^-40 to 2^40

int any_power(Draw& draw) { return draw.integer(smallest_power, largest_power); }

float two_to(int power) { return std::ldexp(1.0f, power); }

Vec3f scaled_along_axes(const Vec3f& v, Draw& draw) {
    const auto of = [&](float x) { return std::ldexp(x, draw.integer(-30, 30)); };
    return {of(v.x), of(v.y), of(v.z)};
}

using adversarial::scaled;  // overloads for vectors

// Multiplies a shape by a power of two. Directions keep their length, because the length of a normal says nothing about
// the size.
Sphere scaled(const Sphere& s, float by) { return {scaled(s.center, by), s.radius * by}; }
Ellipsoid scaled(const Ellipsoid& e, float by) { return {scaled(e.center, by), scaled(e.radii, by)}; }
Cylinder scaled(const Cylinder& c, float by) { return {scaled(c.base, by), scaled(c.top, by), c.radius * by, c.ends}; }
Cone scaled(const Cone& c, float by) {
    return {scaled(c.base, by), scaled(c.top, by), c.base_radius * by, c.top_radius * by, c.ends};
}
Paraboloid scaled(const Paraboloid& p, float by) {
    return {scaled(p.base, by), scaled(p.top, by), p.radius * by, p.ends};
}
Hyperboloid scaled(const Hyperboloid& h, float by) {
    return {scaled(h.base, by), scaled(h.top, by), h.waist * by, h.radius * by, h.ends};
}
Plane scaled(const Plane& p, float by) { return {scaled(p.point, by), p.normal}; }
Disk scaled(const Disk& d, float by) { return {scaled(d.center, by), d.normal, d.radius * by}; }
Annulus scaled(const Annulus& a, float by) {
    return {scaled(a.center, by), a.normal, a.inner_radius * by, a.outer_radius * by};
}
Triangle scaled(const Triangle& t, float by) { return {scaled(t.a, by), scaled(t.b, by), scaled(t.c, by)}; }
Polygon scaled(Polygon p, float by) {
    for (Vec3f& vertex : p.vertices) vertex = scaled(vertex, by);
    return p;
}
std::shared_ptr<const Mesh> scaled(const std::shared_ptr<const Mesh>& mesh, float by) {
    auto result = std::make_shared<Mesh>(*mesh);
    for (Vec3f& vertex : result->vertices) vertex = scaled(vertex, by);
    return result;
}
// It has a name of its own: as an overload it would be called for each shape that has none, and call itself for ever.
Shape scaled_shape(const Shape& shape, float by) {
    return std::visit([&](const auto& each) -> Shape { return scaled(each, by); }, shape);
}

// The shapes are all of one size, or each has a size of its own.
template <class Make>
void for_each_power(Draw& draw, int count, const Make& make) {
    const bool of_one_size = draw.one_in(2);
    const int common = any_power(draw);
    for (int i = 0; i < count; ++i) make(of_one_size ? common : any_power(draw));
}

int few(Draw& draw) { return draw.one_in(10) ? 40 : draw.integer(1, 10); }

// A triangle of size 2^power, at most 2^20 times its size away from the origin.
Triangle triangle_of_size(Draw& draw, int power) {
    const float size = two_to(power);
    const float away = two_to(std::min(power + draw.integer(-4, 20), largest_power));
    const Vec3f place = draw.one_in(2) ? Vec3f(0) : scaled(draw.on_lattice(-3, 3), away);
    const auto corner = [&] { return place + scaled(draw.one_in(2) ? draw.on_lattice(-2, 2) : draw.in_cube(2), size); };
    return {corner(), corner(), corner()};
}

Scene triangles_of_any_size(Draw& draw) {
    std::vector<Triangle> triangles;
    for_each_power(draw, few(draw), [&](int power) { triangles.push_back(triangle_of_size(draw, power)); });
    return scene_of(triangles);
}

Scene shapes_of_any_size(Draw& draw) {
    Scene scene;
    for_each_power(draw, few(draw), [&](int power) {
        scene.objects.push_back(object(scaled_shape(any_shape(draw), two_to(power))));
        scene.objects.back().sides = any_sides(draw);
    });
    return scene;
}

// A transform whose entries differ by many orders of magnitude: it turns a round shape into a needle or a coin.
Affine placement_of_any_size(Draw& draw) {
    Affine placement = any_placement(draw);
    const auto power = [&] { return two_to(draw.integer(-placement_power, placement_power)); };
    const float common = power();
    for (Vec3f& column : placement.columns) column = scaled(column, draw.one_in(2) ? common : power());
    placement.translation = scaled(placement.translation, power());
    return placement;
}

// As large as the cube in which they lie, or few rays would hit them.
std::vector<Triangle> three_triangles(Draw& draw) {
    std::vector<Triangle> triangles(3);
    for (Triangle& each : triangles) each = {draw.in_cube(1), draw.in_cube(1), draw.in_cube(1)};
    return triangles;
}

Scene placed_by_any_size(Draw& draw) {
    Scene scene;
    for (int i = draw.integer(1, 6); i > 0; --i) {
        Object each = any_object(draw);
        if (draw.one_in(2)) each.shape = mesh_of(three_triangles(draw));
        do each.placement = placement_of_any_size(draw);
        while (is_singular(each.placement));
        scene.objects.push_back(std::move(each));
    }
    return scene;
}

// A floor at any height. Its boxes have no thickness, and rays through shared corners hit several triangles at one t,
// which is also the t at which they enter the boxes.
Scene floor_of_any_size(Draw& draw) {
    const float size = two_to(draw.integer(-40, 30));
    const float height = draw.one_in(3) ? 0 : draw.uniform(-4, 4) * std::ldexp(size, draw.integer(-10, 10));
    const int up = draw.integer(0, 2);
    std::vector<Triangle> triangles = floor_of(draw.integer(2, 6));
    for (Triangle& t : triangles)
        for (Vec3f* corner : {&t.a, &t.b, &t.c}) {
            *corner = scaled(*corner, size);
            corner->y = height;
            std::swap(corner->y, (*corner)[up]);
        }
    return scene_of(triangles);
}

// Spheres of the Earth's radius and less; a ray that starts at the Moon's distance reaches them at t = 2^28.5 metres.
Scene planets(Draw& draw) {
    Scene scene;
    for (int i = draw.integer(1, 3); i > 0; --i) {
        const float radius = draw.uniform(1, 7e6);
        scene.objects.push_back(
            object(scaled(std::make_shared<const Mesh>(icosphere(draw.one_in(2) ? 0 : 1)), radius)));
    }
    return scene;
}

// The coordinates of one triangle differ by factors of up to 2^60.
Scene slivers(Draw& draw) {
    std::vector<Triangle> triangles;
    for (int i = few(draw); i > 0; --i)
        triangles.push_back({scaled_along_axes(any_point(draw), draw), scaled_along_axes(any_point(draw), draw),
                             scaled_along_axes(any_point(draw), draw)});
    return scene_of(triangles);
}

}  // namespace

const std::vector<SceneKind>& exponent_scene_kinds() {
    static const std::vector<SceneKind> kinds{
        {"triangles of any size", triangles_of_any_size},
        {"shapes of any size", shapes_of_any_size},
        {"placed by any size", placed_by_any_size},
        {"floor of any size", floor_of_any_size},
        {"planets", planets},
        {"slivers", slivers},
    };
    return kinds;
}

std::vector<SceneKind> every_scene_kind() {
    std::vector<SceneKind> kinds = scene_kinds();
    kinds.insert(kinds.end(), exponent_scene_kinds().begin(), exponent_scene_kinds().end());
    kinds.insert(kinds.end(), moving_scene_kinds().begin(), moving_scene_kinds().end());
    return kinds;
}

}  // namespace raylab::adversarial
