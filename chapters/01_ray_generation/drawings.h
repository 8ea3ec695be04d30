#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/image.h"
#include "raylab/scene/camera.h"

#include <cstdint>

// The chapter's annotated pictures: the scene as seen by a bystander, with cameras and rays drawn into it.

namespace raylab::ray_generation {

/// A scene with its accelerator.
struct Stage {
    const Scene& scene;
    const Accelerator& accelerator;
    int threads;
};

/// Draws the camera's eye, its three axes, its picture rectangle, and the ray through one pixel.
Image draw_camera(const Stage& stage, const CameraFrame& frame);

/// Draws the rays through a few pixels: a fan from one eye, or parallels from a rectangle.
Image draw_bundle(const Stage& stage, const CameraFrame& frame);

/// Draws light rays from the light and their continuations, lighter to darker with each segment.
Image draw_light_paths(const Stage& stage, const CameraFrame& frame, std::uint64_t seed);

/// Draws a few eye rays, each with the ray from its surface to the light.
Image draw_eye_paths(const Stage& stage, const CameraFrame& frame);

}  // namespace raylab::ray_generation
