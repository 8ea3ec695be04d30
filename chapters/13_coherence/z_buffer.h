#pragma once

#include "raylab/geometry/shapes.h"
#include "raylab/scene/camera.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace raylab::coherence {

/// A triangle of the mesh for each pixel, row after row; absent where none is visible.
using Items = std::vector<std::optional<std::uint32_t>>;

/// The item buffer as it was published: triangles are projected and sampled at pixel centers, and of two the nearer is
/// kept, all in numbers of type T (float, double). A triangle with a vertex behind the eye is not drawn.
template <Real T>
Items z_buffer(const Mesh& mesh, const CameraFrame& frame);

extern template Items z_buffer<float>(const Mesh&, const CameraFrame&);
extern template Items z_buffer<double>(const Mesh&, const CameraFrame&);

}  // namespace raylab::coherence
