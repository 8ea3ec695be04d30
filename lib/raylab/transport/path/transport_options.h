#pragma once

#include "raylab/sampling/sampler.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/shading/ray_start.h"
#include "raylab/transport/lobe/rough_lobe.h"

#include <limits>

namespace raylab {

/// How far paths are followed.
enum class Followed {
    sharp_and_glossy,  // mirrors and glass: diffuse surfaces see lights alone (Cook, Porter and Carpenter 1984)
    all,               // diffuse surfaces too: all of the light (Kajiya 1986)
};

/// How the light of emitting surfaces is found at points that spread light.
enum class LightStrategy {
    both,    // weighted by the power heuristic
    lights,  // by points on lights alone
    lobes,   // by directions of the lobe alone, which hit lights now and then
};

struct TransportOptions {
    Followed followed = Followed::sharp_and_glossy;
    LightStrategy strategy = LightStrategy::both;
    int depth = std::numeric_limits<int>::max();  // of a path; the eye ray has depth 1
    FacetShares shares = FacetShares::coefficients;
    RayStart start = {};
};

}  // namespace raylab
