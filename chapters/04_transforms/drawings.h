#pragma once

#include "raylab/geometry/shapes.h"
#include "raylab/image/image.h"
#include "raylab/scene/scene.h"

#include <memory>

// The chapter's own pictures.

namespace raylab::transforms {

/// One ray in two spaces: on the left the world with a sheared disk, on the right the space in which the disk is round.
/// The marks on the ray are at the same t in both.
Image draw_two_spaces();

/// A shaded picture; the normals are transformed by the inverse transpose or, wrongly, like points.
enum class NormalsCarried { by_inverse_transpose, like_points };
Image draw_normals(const Scene& scene, NormalsCarried carried, int threads);

/// The scene's camera and floor, with one mesh placed `rows` x `rows` times; every object shares it.
Scene herd(const Scene& scene, const std::shared_ptr<const Mesh>& mesh, int rows);

}  // namespace raylab::transforms
