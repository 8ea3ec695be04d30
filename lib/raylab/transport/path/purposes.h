#pragma once

#include "raylab/scene/camera.h"
#include "raylab/transport/light/area_lights.h"

// What a path's random numbers are used for. Each use has numbers of its own: two uses that shared one would depend on
// each other (case SAME-NUMBER-TWICE).

namespace raylab::purpose {

inline constexpr int picture = 0, lens = 1, time = 2;  // of the eye ray

/// At a vertex of a path, numbered from 0: the first surface that is hit.
enum AtVertex { light_choice, light_point, lobe_choice, lobe_direction, roulette, count };

constexpr int at(int vertex, AtVertex use) { return 3 + vertex * AtVertex::count + use; }

/// The purpose that blurs most pictures of a scene, after the pixel itself: Sampler::beside_first.
inline int beside_picture(const Camera& camera, const AreaLights& lights) {
    if (camera.lens && camera.lens->radius > 0) return lens;
    return at(0, lights.empty() ? lobe_direction : light_point);
}

}  // namespace raylab::purpose
