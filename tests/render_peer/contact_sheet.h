#pragma once

#include "raylab/scene/scene.h"

#include <cstdint>

/// Random shapes in cells of 64 x 64 pixels, each with a material on either side. A row for each kind of shape but the
/// infinite plane; a column for each kind of placement (none, rotation, mirror, another scale per axis, shear), once
/// for shapes seen from both sides, once from their front and once from their back.
raylab::Scene contact_sheet(std::uint64_t seed);

/// The same of infinite planes: they stand around the camera.
raylab::Scene room_of_planes(std::uint64_t seed);

/// The scene seen from across the camera's target.
raylab::Scene from_behind(raylab::Scene scene);
