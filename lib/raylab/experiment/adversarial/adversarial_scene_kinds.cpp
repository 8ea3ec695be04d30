#include "raylab/experiment/adversarial/adversarial_scenes.h"

#include "raylab/experiment/generate/loose_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab::adversarial {

namespace {

using Triangles = std::vector<Triangle>;

// The number of primitives is mostly so small that hundreds of rays through each scene cost little, and now and then as
// large as structures are made for.
std::size_t some(Draw& draw) {
    return static_cast<std::size_t>(draw.one_in(10) ? draw.integer(100, 400) : draw.integer(2, 24));
}

int a_dozen(Draw& draw) { return draw.one_in(10) ? 60 : draw.integer(1, 12); }

Scene one_triangle(Draw& draw) {
    if (draw.one_in(2)) return scene_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    return scene_of({{any_point(draw), any_point(draw), any_point(draw)}});
}

// Axis-aligned right triangles in one plane: their boxes have no thickness, and many boxes are the same.
Scene flat(Draw& draw) {
    if (draw.one_in(2)) return scene_of(floor_of(draw.integer(1, 6)));
    Triangles triangles = soup(draw, some(draw), 2);
    const int axis = draw.integer(0, 2);
    for (Triangle& t : triangles) t.a[axis] = t.b[axis] = t.c[axis] = 1;
    return scene_of(triangles);
}

Scene duplicates(Draw& draw) {
    const Triangles once = soup(draw, 3, 2);
    Triangles triangles;
    for (std::size_t i = some(draw); i > 0; --i) triangles.push_back(once[i % 3]);
    return scene_of(triangles);
}

Scene degenerate(Draw& draw) {
    Triangles triangles = soup(draw, some(draw), 2);
    for (std::size_t i = 0; i < triangles.size(); i += 2) triangles[i].c = i % 4 == 0 ? triangles[i].a : triangles[i].b;
    return scene_of(triangles);
}

// Concentric spheres, and triangles that share corners of their boxes.
Scene nested(Draw& draw) {
    Scene scene;
    const Vec3f center = any_point(draw);
    for (int i = draw.integer(2, 20); i > 0; --i) {
        const float size = std::ldexp(1.0f, draw.integer(-6, 3));
        if (draw.one_in(2))
            scene.objects.push_back(object(Sphere{center, size}));
        else
            scene.objects.push_back(
                object(Triangle{center, center + Vec3f(size, 0, 0), center + Vec3f(0, size, size)}));
    }
    return scene;
}

// The distances between centers grow so fast that a split in the spatial middle never helps.
Scene far_apart(Draw& draw) {
    Triangles triangles;
    for (int i = -140; i < 120; i += draw.integer(1, 12)) {
        const float x = std::ldexp(1.0f, i);
        triangles.push_back({{x, 0, 0}, {x * 1.5f, x, 0}, {x, 0, x * draw.uniform(0.5f, 1)}});
    }
    return scene_of(triangles);
}

// Several instances of one mesh.
Scene placed(Draw& draw) {
    Scene scene;
    const Shape mesh = mesh_of(soup(draw, some(draw) / 3 + 1, 1));
    for (int i = draw.integer(1, 4); i > 0; --i) scene.objects.push_back(object(mesh, any_placement(draw)));
    return scene;
}

// The transform moves the ends of boxes beyond the floats, to infinity.
Scene beyond_floats(Draw& draw) {
    Scene scene = any_scene(draw, a_dozen(draw));
    for (Object& each : scene.objects)
        if (draw.one_in(2))
            for (Vec3f& column : each.placement.columns)
                column = scaled(column, std::ldexp(1.0f, draw.integer(100, 126)));
    std::erase_if(scene.objects, [](const Object& each) {
        const auto& [x, y, z] = each.placement.columns;
        const auto finite = [](const Vec3f& v) {
            return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
        };
        return !finite(x) || !finite(y) || !finite(z) || is_singular(each.placement);
    });
    return scene;
}

// Small shapes inside a very large one, and planes beside bounded shapes ("a teapot in a stadium").
Scene teapot_in_a_stadium(Draw& draw) {
    const Vec3f center = draw.in_cube(50);
    Triangles triangles = soup(draw, some(draw), 0.01f, center);
    triangles.push_back({{-100, 0, -100}, {100, 0, -100}, {100, 0, 100}});
    Scene scene = scene_of(triangles);
    if (draw.one_in(3)) scene.objects.push_back(object(Plane{{0, -1, 0}, {0, 1, 0}}));
    return scene;
}

}  // namespace

const std::vector<SceneKind>& scene_kinds() {
    static const std::vector<SceneKind> kinds{
        {"empty", [](Draw&) { return Scene{}; }},
        {"one triangle", one_triangle},
        {"one shape", [](Draw& draw) { return any_scene(draw, 1); }},
        {"soup", [](Draw& draw) { return scene_of(soup(draw, some(draw), 2)); }},
        {"flat", flat},
        {"duplicates", duplicates},
        {"degenerate", degenerate},
        {"nested", nested},
        {"at 1e6", [](Draw& draw) { return scene_of(soup(draw, some(draw), 2, Vec3f(1e6f))); }},
        {"tiny", [](Draw& draw) { return scene_of(soup(draw, some(draw), 1e-20f)); }},
        {"huge", [](Draw& draw) { return scene_of(soup(draw, some(draw), 1e20f)); }},
        {"far apart", far_apart},
        {"placed meshes", placed},
        {"all shapes", [](Draw& draw) { return any_scene(draw, a_dozen(draw)); }},
        {"beyond floats", beyond_floats},
        {"teapot in a stadium", teapot_in_a_stadium},
    };
    return kinds;
}

}  // namespace raylab::adversarial
