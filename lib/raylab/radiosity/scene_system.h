#pragma once

#include "raylab/base/error.h"
#include "raylab/radiosity/mesh/patch_mesh.h"

#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// The share of light that a patch reflects: its material's diffuse colour at its centre.
Color patch_reflectance(const PatchMesh& mesh, const Patch& patch);

/// What a scene has that radiosity does not show, in printable words; empty: nothing. Mirrors and glass send light into
/// one direction, and a highlight depends on the viewer.
std::vector<std::string> beyond_radiosity(const Scene& scene);

/// Why a scene cannot be solved by radiosity at all, as an error would say it; absent: it can.
std::optional<std::string> refused_by_radiosity(const Scene& scene);

/// Throws an Error where a material's diffuse colour leaves [0, 1) in some channel: its patches would reflect all light
/// or more, and the light between two of them would never end.
void check_reflectances(const Scene& scene);

/// What is said of a scene in which nothing emits light.
Error no_light(const Scene& scene);

}  // namespace raylab
