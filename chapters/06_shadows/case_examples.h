#pragma once

#include "shadow_rays.h"

#include "raylab/report/stability.h"

namespace raylab::shadows {

/// A shadow ray whose answer is wrong, drawn from its own numbers in the plane of the surface's normal and the light:
/// where it begins, and what it hits (`truth` lit) or passes over (`truth` blocked).
CaseExample example_of(const Scene& scene, const NamedStart& start, const ShadowQuestion& question, Shade truth);

}  // namespace raylab::shadows
