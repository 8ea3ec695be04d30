#pragma once

#include "raylab/geometry/ray.h"
#include "raylab/scene/scene.h"
#include "raylab/transport/light/light_shape.h"

#include <optional>
#include <vector>

namespace raylab {

/// A part of an object that emits, with one formula for its points.
struct LightPiece {
    LightShape shape;
    Primitive primitive;
    Color front, back;        // the radiance sent on the side of the outward normal, and on the other
    Vec3d velocity{0, 0, 0};  // metres a second; the shape is where it stands at time 0
};

/// The pieces of an object: one for each triangle of a mesh or of a polygon, otherwise one. Absent where its shape
/// cannot be sampled: planes, cylinders, cones, paraboloids, hyperboloids, and what turns or is stretched while it
/// moves. `number` is its index in Scene::objects.
std::optional<std::vector<LightPiece>> light_pieces(const Scene& scene, std::uint32_t number);

}  // namespace raylab
