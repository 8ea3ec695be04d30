#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/experiment/generate/loose_triangles.h"
#include "raylab/geometry/singular_motion.h"
#include "raylab/scene/moving.h"

#include <algorithm>
#include <cmath>

// Scenes in which things move. Their objects stand at every place between two at the times of the rays.

namespace raylab::adversarial {

namespace {

Shutter any_shutter(Draw& draw) {
    switch (draw.integer(0, 3)) {
        case 0:
            return {0, 1};
        case 1:
            return {0.25, 1 / 3.0};
        case 2:
            return {-1, 2};
        default:
            return {draw.number(-1, 0), draw.number(0, 1)};
    }
}

Motion scaled_motion(Motion motion, float by) {
    for (Vec3f& column : motion.columns) column = scaled(column, by);
    motion.translation = scaled(motion.translation, by);
    return motion;
}

// Two in three objects move, the others are at rest, as are some that have a motion of zero.
Scene set_moving(Draw& draw, Scene scene, float speed = 1) {
    scene.camera.shutter = any_shutter(draw);
    for (Object& each : scene.objects) {
        if (draw.one_in(3)) continue;
        do each.motion = draw.one_in(8) ? Motion{} : scaled_motion(any_motion(draw), speed);
        while (is_singular_during(each.placement, *each.motion, ray_times(scene)));
    }
    return scene;
}

Scene moving_shapes(Draw& draw) {
    return set_moving(draw, any_scene(draw, draw.one_in(10) ? 40 : draw.integer(1, 12)));
}

// Many triangles that go the same way, and others.
Scene moving_meshes(Draw& draw) {
    Scene scene;
    for (int i = draw.integer(1, 3); i > 0; --i) {
        const Affine placement = any_placement(draw);
        const int count = draw.one_in(10) ? 120 : draw.integer(1, 20);
        scene.objects.push_back(object(mesh_of(soup(draw, static_cast<std::size_t>(count), 2)), placement));
    }
    return set_moving(draw, std::move(scene));
}

// Rays hit shared edges and corners, two floors that pass through each other at once, and boxes without thickness.
Scene moving_floors(Draw& draw) {
    Scene scene = scene_of(floor_of(draw.integer(1, 5)));
    scene.objects.push_back(scene.objects[0]);
    scene.camera.shutter = Shutter{0, 1};
    for (Object& each : scene.objects) each.motion = Motion{.translation = draw.on_lattice(-2, 2)};
    return scene;
}

// Everything is of one size, which may be any; speeds are of other sizes.
Scene moving_by_any_size(Draw& draw) {
    const float size = std::ldexp(1.0f, draw.integer(-40, 40));
    Scene scene;
    for (int i = draw.integer(1, 8); i > 0; --i) {
        Object each = any_object(draw);
        for (Vec3f& column : each.placement.columns) column = scaled(column, size);
        each.placement.translation = scaled(each.placement.translation, size);
        scene.objects.push_back(std::move(each));
    }
    return set_moving(draw, std::move(scene), std::ldexp(size, draw.one_in(2) ? 0 : draw.integer(-30, 30)));
}

}  // namespace

const std::vector<SceneKind>& moving_scene_kinds() {
    static const std::vector<SceneKind> kinds{
        {"moving shapes", moving_shapes},
        {"moving meshes", moving_meshes},
        {"moving floors", moving_floors},
        {"moving by any size", moving_by_any_size},
    };
    return kinds;
}

}  // namespace raylab::adversarial
