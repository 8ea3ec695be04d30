#pragma once

#include "raylab/geometry/ray_triangle/methods.h"
#include "raylab/image/image.h"
#include "raylab/scene/camera.h"

namespace raylab {

/// What an eye sees of a mesh, each ray asked about every triangle by this method: surfaces dark, nothing bright. From
/// inside a closed mesh, what is bright is light that leaks.
Image mesh_picture(const TriangleMethod& method, const Mesh& mesh, const CameraFrame& frame, int threads);

/// The middle of the edge through which most rays from this eye leak, of all edges of a closed mesh.
Vec3d leakiest_point(const TriangleMethod& method, const Mesh& mesh, const Vec3f& eye);

/// What to do with the weights of a hit.
enum class Interpolated { nothing, colors, normals };

/// A coarse ball: by its flat normals, by vertex colours red, green and blue, or by normals mixed from its vertices.
Image ball_picture(Interpolated interpolated, ImageSize size, int threads);

}  // namespace raylab
