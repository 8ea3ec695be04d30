#pragma once

#include "raylab/geometry/affine.h"
#include "raylab/geometry/ray.h"
#include "raylab/scene/scene.h"
#include "raylab/transport/light/light_shape.h"

#include <optional>
#include <vector>

namespace raylab {

/// The way of a light that turns or stretches while it moves: its place is placement + t motion.
struct TurningLight {
    Affine placement;
    Motion motion;
};

/// A part of an object that emits, with one formula for its points.
struct LightPiece {
    LightShape shape;  // where it stands at time 0; of a light that turns, in the object's own coordinates
    Primitive primitive;
    Color front, back;        // the radiance sent on the side of the outward normal, and on the other
    Vec3d velocity{0, 0, 0};  // metres a second
    std::optional<TurningLight> turning = {};
};

/// The shape of a piece that turns, where it stands at a time. A map of a plane enlarges all areas in it alike, so the
/// parts of a polygon keep their shares.
LightShape turned_shape(const LightPiece& piece, float time);

/// The pieces of an object: one for each triangle of a mesh or of a polygon, otherwise one. Absent where its shape
/// cannot be sampled: planes, cylinders, cones, paraboloids, hyperboloids. `number` is its index in Scene::objects.
std::optional<std::vector<LightPiece>> light_pieces(const Scene& scene, std::uint32_t number);

}  // namespace raylab
