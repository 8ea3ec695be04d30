#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/image/image.h"
#include "raylab/sampling/share.h"
#include "raylab/scene/camera.h"

#include <array>
#include <cstdint>
#include <vector>

// The same light followed both ways: backward, from the eye through each pixel to a surface and on to the lamp, and
// forward, from the lamp to a surface and on, wherever it may go. Surfaces are diffuse, the one lamp is a point.

namespace raylab::ray_generation {

/// Where a light ray's story ends.
enum class Fate {
    in_picture,      // met the eye, through a pixel
    beside_picture,  // met the eye, from outside the field of view
    absorbed,        // by a surface
    left,            // for the sky
};
inline constexpr std::size_t fates = 4;

/// A disk at the eye, across the view: what forward rays have to meet. A pinhole has radius 0.
struct ForwardOptions {
    double eye_radius = 0.1;       // metres
    std::uint64_t light_rays = 0;  // sent from the lamp
    int longest_path = 16;         // segments; what is left of a path then counts as absorbed
    std::uint64_t seed = 1;
    int threads = 0;
};

struct ForwardResult {
    std::array<std::uint64_t, fates> ended{};  // by Fate
    std::uint64_t light_rays = 0;
    std::uint64_t segments = 0;  // rays traced in all
    Image picture;               // radiance; light that met the eye's disk is drawn at the point it last came from

    Share share(Fate fate) const { return share_of(ended[static_cast<std::size_t>(fate)], light_rays); }
};

ForwardResult trace_forward(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                            const ForwardOptions& options);

struct BackwardResult {
    Image picture;           // radiance that came from the lamp by way of one surface
    std::uint64_t segments;  // rays traced in all
};

/// One eye ray through each of n x n samples of a pixel, and one on to the lamp from what it meets.
BackwardResult trace_backward(const Scene& scene, const Accelerator& accelerator, const CameraFrame& frame,
                              int samples_per_side, int threads);

/// The stations of one light ray's path, lamp first: for drawing.
std::vector<Vec3d> light_path(const Scene& scene, const Accelerator& accelerator, std::uint64_t seed, std::uint64_t ray,
                              int longest_path);

}  // namespace raylab::ray_generation
