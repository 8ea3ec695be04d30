#pragma once

#include "raylab/experiment/ray_triangle/methods.h"
#include "raylab/image/image.h"
#include "raylab/scene/camera.h"

namespace raylab {

/// The picture of a mesh for which this method tests each ray against every triangle: surfaces are dark, the background
/// is bright. From inside a closed mesh, whatever is bright is light that leaks.
Image mesh_picture(const TriangleMethod& method, const Mesh& mesh, const CameraFrame& frame, int threads);

/// The middle of the edge through which most rays from this eye leak, of all edges of a closed mesh.
Vec3d leakiest_point(const TriangleMethod& method, const Mesh& mesh, const Vec3f& eye);

/// What the weights of a hit are used for.
enum class Interpolated { nothing, colors, normals };

/// A coarse sphere: by its flat normals, by vertex colours red, green and blue, or by normals interpolated from its
/// vertices.
Image ball_picture(Interpolated interpolated, ImageSize size, int threads);

}  // namespace raylab
