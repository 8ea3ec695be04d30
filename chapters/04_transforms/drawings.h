#pragma once

#include "raylab/geometry/shapes.h"
#include "raylab/image/image.h"
#include "raylab/scene/camera.h"

#include <memory>

// The chapter's own pictures.

namespace raylab::transforms {

/// A shaded picture: lit in the world, as it should be; with normals that were carried like points; or in object space,
/// to which the light is carried.
enum class Lit { in_world, with_normals_like_points, in_object_space };
Image draw_lit(const Scene& scene, const CameraFrame& frame, Lit lit, int threads);

/// The scene's camera and floor, with one mesh placed `rows` x `rows` times; every object shares it.
Scene herd(const Scene& scene, const std::shared_ptr<const Mesh>& mesh, int rows);

}  // namespace raylab::transforms
