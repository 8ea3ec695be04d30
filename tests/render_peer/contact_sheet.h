#pragma once

#include "raylab/scene/scene.h"

#include <cstdint>

/// Random shapes in cells of 64 x 64 pixels, each with a material on either side. There is a row for each kind of shape
/// except the infinite plane, and a column for each kind of transform (none, rotation, mirror, another scale for each
/// axis, shear), once for shapes seen from both sides, once from their front and once from their back.
raylab::Scene contact_sheet(std::uint64_t seed);

/// The same for infinite planes, which are around the camera.
raylab::Scene room_of_planes(std::uint64_t seed);

/// The scene seen from the opposite side of the camera's target.
raylab::Scene from_behind(raylab::Scene scene);
