#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/image.h"
#include "raylab/scene/camera.h"

#include <cstdint>

// The chapter's annotated pictures: the scene seen by a bystander, with cameras and rays drawn into it.

namespace raylab::ray_generation {

/// A scene with the structure that answers for it.
struct Stage {
    const Scene& scene;
    const Accelerator& accelerator;
    int threads;
};

/// The camera's eye, its three axes, its picture rectangle, and the ray through one pixel.
Image draw_camera(const Stage& stage, const CameraFrame& frame);

/// The rays through a few pixels: a fan from one eye, or parallels from a rectangle.
Image draw_bundle(const Stage& stage, const CameraFrame& frame);

/// Light rays from the lamp and where they go on to, lighter to darker with each segment.
Image draw_light_paths(const Stage& stage, const CameraFrame& frame, std::uint64_t seed);

/// A few eye rays, each sent on from its surface to the lamp.
Image draw_eye_paths(const Stage& stage, const CameraFrame& frame);

/// Pixels with their samples, for each pattern.
Image draw_sample_patterns(std::uint64_t seed);

}  // namespace raylab::ray_generation
