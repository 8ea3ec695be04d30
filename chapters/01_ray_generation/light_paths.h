#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/image.h"
#include "raylab/sampling/share.h"
#include "raylab/scene/camera.h"

#include <array>
#include <cstdint>
#include <vector>

// The same light followed both ways: backward, from the eye through each pixel to a surface and on to the light, and
// forward, from the light to a surface and on in a random direction. Surfaces are diffuse, and the only light is a
// point.

namespace raylab::ray_generation {

/// Where a light ray's path ends.
enum class Fate {
    in_picture,      // hits the eye, through a pixel
    beside_picture,  // hits the eye, from outside the field of view
    absorbed,        // by a surface
    left,            // into the sky
};
inline constexpr std::size_t fates = 4;

/// The eye's disk, perpendicular to the view, which forward rays have to hit. A pinhole has radius 0.
struct ForwardOptions {
    double eye_radius = 0.1;       // in metres
    std::uint64_t light_rays = 0;  // sent from the light
    int longest_path = 16;         // in segments; a longer path counts as absorbed
    std::uint64_t seed = 1;
    int threads = 0;
};

struct ForwardResult {
    std::array<std::uint64_t, fates> ended{};  // indexed by Fate
    std::uint64_t light_rays = 0;
    std::uint64_t segments = 0;  // number of rays traced
    Image picture;               // radiance; light that hits the eye's disk is drawn at the point from which it came

    Share share(Fate fate) const { return share_of(ended[static_cast<std::size_t>(fate)], light_rays); }
};

ForwardResult trace_forward(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                            const ForwardOptions& options);

struct BackwardResult {
    Image picture;           // radiance that comes from the light by way of one surface
    std::uint64_t segments;  // number of rays traced
};

/// Traces one eye ray through each of n x n samples of a pixel, and one ray from the point it hits to the light.
BackwardResult trace_backward(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                              int samples_per_side, int threads);

/// The points of one light ray's path, beginning with the light, for drawing.
std::vector<Vec3d> light_path(const Scene& scene, const Accelerator& accelerator, std::uint64_t seed, std::uint64_t ray,
                              int longest_path);

}  // namespace raylab::ray_generation
