#pragma once

#include "raylab/radiosity/visibility.h"
#include "raylab/tracer/shading/illumination.h"

#include <vector>

namespace raylab {

/// What lights give a patch: the power per area that arrives, as a mean over points, and by how much the points differ
/// (of the mean of the channels).
struct ArrivingLight {
    Color mean{0, 0, 0};
    double spread = 0;
};

/// The scene's point, spot and distant lights, as patches receive them. A light gives pi color attenuation cos, so a
/// white surface that faces it has the radiance `color`, as in Whitted's model.
class PatchLights {
public:
    PatchLights(const PatchMesh& mesh, const PatchVisibility& visibility);

    /// What arrives on a part of a patch, from `points` points, each with a shadow ray to each light.
    ArrivingLight on(const PatchVisibility::Part& part, int points, Traversal& traversal) const;

    /// What arrives at one point of a part.
    Color at(const PatchVisibility::Part& part, const Vec3d& point, Traversal& traversal) const;

    bool empty() const { return lights_.empty(); }

private:
    Color arriving(const ShadingLight& light, const PatchVisibility::Part& part, const Vec3d& point,
                   Traversal& traversal) const;

    const PatchVisibility& visibility_;
    std::vector<ShadingLight> lights_;
};

/// What the lights give each patch.
std::vector<Color> direct_light(const PatchMesh& mesh, const PatchVisibility& visibility, int points, int threads);

/// What the background gives a patch, power per area: pi times the mean radiance that it sees outside, times the share
/// of its view that neither patches fill nor sides without patches.
Color background_light(const PatchVisibility::Surroundings& around, double filled);

}  // namespace raylab
