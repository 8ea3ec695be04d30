#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/tracer/media/media.h"
#include "raylab/tracer/shading/ray_start.h"
#include "raylab/tracer/whitted/ray_tree.h"

#include <cstdint>

// Whitted's recursion: I = I_local + k_r I_reflected + k_t I_transmitted. (An Improved Illumination Model for Shaded
// Display, CACM 23(6), 1980; chapter 07.)

namespace raylab {

/// The recursion is followed this far, and these variants of the model are chosen.
struct WhittedOptions {
    int depth = 5;  // of the ray tree; the eye ray has depth 1
    double threshold =
        0;  // a ray whose throughput is not above it is not followed (Hall and Greenberg 1983); below 0: all are
    enum class Reflectance {
        constant,  // kr and kt as the material has them
        fresnel,   // what transmits splits kr + kt by the angle
    } reflectance = Reflectance::constant;
    enum class Viewer { local, at_infinity } viewer = Viewer::local;  // where highlights are seen from
    Vec3d to_viewer{0, 0, 1};                                         // of Viewer::at_infinity, unit
    enum class Lit {
        viewers_side,  // light counts on the side of the surface that is looked at
        outer_side,    // ... on the outer side, from wherever it is looked at
    } lit = Lit::viewers_side;
    enum class Shadows { cast, none } shadows = Shadows::cast;  // none: no shadow rays, every light is seen
    RayStart start = {};
};

/// How many rays of a kind were cast, and how many of them hit a surface.
struct CastAndHit {
    std::uint64_t cast = 0, hit = 0;

    void add(const CastAndHit& other) {
        cast += other.cast;
        hit += other.hit;
    }
};

/// The rays that were traced for a picture, by kind.
struct RayCounts {
    CastAndHit primary, shadow, secondary;

    void add(const RayCounts& other) {
        primary.add(other.primary);
        shadow.add(other.shadow);
        secondary.add(other.secondary);
    }
};

/// The colour along one eye ray, which starts in these media (tracer/media/eye_media.h; absent: in none).
Color whitted_color(const Scene& scene, const Accelerator& accelerator, const WhittedOptions& options, const Ray& ray,
                    Traversal& traversal, const Media& around_eye = {});

/// The same, counting rays.
Color whitted_color(const Scene& scene, const Accelerator& accelerator, const WhittedOptions& options, const Ray& ray,
                    Traversal& traversal, RayCounts& counts, const Media& around_eye = {});

/// The same, keeping every ray, and finding the media.
RayTree ray_tree(const Scene& scene, const Accelerator& accelerator, const WhittedOptions& options, const Ray& ray);

}  // namespace raylab
