#pragma once

#include "raylab/radiosity/form_factors.h"
#include "raylab/scene/scene.h"

#include <vector>

namespace raylab {

/// The radiosity equation of n patches, B_i = E_i + rho_i sum_j F_ij B_j, in each colour channel: what leaves a patch
/// is what it emits and the reflected share of what arrives. (Goral, Torrance, Greenberg and Battaile, SIGGRAPH 84.)
struct RadiositySystem {
    std::vector<double> area;        // m^2
    std::vector<Color> emission;     // E: power emitted per area, pi times the radiance
    std::vector<Color> reflectance;  // rho, in [0, 1)
    FormFactors form_factors;

    std::size_t patches() const { return area.size(); }
};

/// B of each patch: the power per area that leaves it.
using Radiosities = std::vector<Color>;

}  // namespace raylab
