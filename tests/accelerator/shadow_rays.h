#pragma once

#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/shape_parts.h"
#include "raylab/tracer/shading/ray_start.h"

#include <cmath>
#include <optional>

// Lights that are hard for light buffers, and shadow rays to them.

namespace raylab::adversarial {

// A direction from the light that is hard: along the border of two cells, along the cube's edges or through its
// corners.
inline Vec3d any_way(Draw& draw, int resolution) {
    Vec3d way = convert<double>(draw.in_cube(1));
    const auto border = [&] { return 2.0 * draw.integer(0, resolution) / resolution - 1; };
    const int axis = draw.integer(0, 2);
    if (draw.one_in(2)) way[axis] = draw.one_in(2) ? 1 : -1;
    if (draw.one_in(2)) way[(axis + 1) % 3] = border();
    if (draw.one_in(3)) way[(axis + 2) % 3] = border();
    if (draw.one_in(10)) way = convert<double>(draw.lattice_direction(1));
    return way;
}

// A corner of a shape, or a point of an edge, where shadows have their borders.
inline std::optional<Vec3d> some_corner(Draw& draw, const Scene& scene) {
    if (scene.objects.empty()) return std::nullopt;
    const Object& object =
        scene.objects[static_cast<std::size_t>(draw.integer(0, static_cast<int>(scene.objects.size()) - 1))];
    const auto between = [&](const Vec3f& a, const Vec3f& b) {
        const Vec3d p = convert<double>(a), q = convert<double>(b);
        return transform_point(object.placement, draw.one_in(2) ? p : p + (q - p) * draw.number(0, 1));
    };
    if (const Mesh* mesh = as_mesh(object.shape)) {
        const Triangle t =
            mesh->triangle(static_cast<std::size_t>(draw.integer(0, static_cast<int>(mesh->faces.size()) - 1)));
        return between(t.a, t.b);
    }
    if (const auto* t = std::get_if<Triangle>(&object.shape)) return between(t->b, t->c);
    if (const auto* polygon = std::get_if<Polygon>(&object.shape))
        return between(polygon->vertices[0], polygon->vertices[1]);
    const auto box = bounds(object.shape, object.placement);
    return box ? std::optional(convert<double>(box->min)) : std::nullopt;
}

// A light on the scene's lattice, in its objects, or at a distance of 10^-1 to 10^-8 of the scene's size from a corner
// of one.
inline Vec3d any_light(Draw& draw, const Scene& scene, double size) {
    if (draw.one_in(3)) return convert<double>(draw.on_lattice(-4, 4)) * (size / 3);
    if (draw.one_in(3) && !scene.objects.empty())
        return transform_point(scene.objects[0].placement, convert<double>(any_point(draw)) * (size / 3));
    const auto corner = draw.one_in(3) ? some_corner(draw, scene) : std::nullopt;
    if (corner) return *corner + convert<double>(draw.in_cube(1)) * (size * std::pow(10.0, draw.integer(-8, -1)));
    return convert<double>(draw.in_cube(2)) * size;
}

// A shadow ray as the tracer casts it: from floats, in a direction of floats, to slightly less than the distance to the
// light.
inline Ray shadow_ray_to(const Vec3d& light, const Vec3d& point) {
    const Vec3f origin = convert<float>(point);
    const Vec3d way = light - convert<double>(origin);
    const double distance = glm::length(way);
    return {origin, convert<float>(way / distance), {0, cast<float>(length_of_shadow_ray(distance))}};
}

// Large walls, which cover many cells, among small objects: balls, triangles and quadrilaterals.
inline Scene room(Draw& draw) {
    Scene scene;
    const auto add = [&](Shape shape) {
        scene.objects.push_back(object(std::move(shape)));
        if (draw.one_in(4)) scene.objects.back().sides = any_sides(draw);
    };
    for (int i = 0; i < 4; ++i) {
        const Vec3f at = draw.in_cube(4), u = draw.lattice_direction(4), v = draw.in_cube(4);
        add(Polygon{{at, at + u, at + u + v, at + v}});
        add(Polygon{// Not planar: its surface does not contain its corners.
                    {at, at + u, at + u + v + draw.in_cube(0.7), at + v}});
        add(Polygon{{at, at + u, at + v, at, at + u, at + v}});  // goes round twice, so nothing is inside
        add(Triangle{at + u, draw.in_cube(5), draw.in_cube(5)});
        add(Sphere{draw.in_cube(4), any_radius(draw)});
        add(Sphere{draw.in_cube(4), draw.uniform(0.01, 0.1)});
    }
    return scene;
}

}  // namespace raylab::adversarial
