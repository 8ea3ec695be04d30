#pragma once

#include "raylab/scene/camera.h"
#include "raylab/tracer/whitted/ray_tree.h"

// The scene in which a function of the tracer is tried when its exercise's cases went wrong: it contains what each of
// these functions can get wrong. It is generated, so that a student's process need not open a file.

namespace raylab::grading {

struct TracedScene {
    Scene scene;
    CameraFrame frame;
    int limit;  // depth of the deepest ray

    /// All rays through the center of a pixel, by the textbook's tracer.
    RayTree tree(int x, int y) const;
};

inline constexpr ImageSize traced_size{96, 72};  // small, because someone waits while it is drawn

TracedScene traced_scene(ImageSize size = traced_size);

}  // namespace raylab::grading
