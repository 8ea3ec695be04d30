#pragma once

#include "raylab/sampling/sequence.h"
#include "raylab/transport/light/area_lights.h"

#include <cmath>
#include <numbers>

namespace raylab::lights {

/// A scene of one shape that shines with radiance 1 on both sides.
inline Scene lit_by(const Shape& shape, const Affine& placement = {}, Sides sides = Sides::both) {
    Scene scene;
    scene.materials = {Material{.name = "light", .emission = Color(1)}};
    scene.objects = {Object{.shape = shape, .placement = placement, .sides = sides, .path = "light"}};
    return scene;
}

struct Estimate {
    double mean, error;  // its standard error
};

/// The irradiance over pi of a patch whose view is free: nothing is asked what hides a light, not even its near side.
inline Estimate irradiance_over_pi(const AreaLights& lights, const Vec3d& at, const Vec3d& normal, int samples) {
    double sum = 0, squares = 0;
    for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(samples); ++i) {
        RandomSequence random(67, i);
        const double u = random.next(), v = random.next();
        const auto light = lights.sample(at, random.next(), {u, v});
        if (!light) continue;
        const double cosine = dot(light->direction, normal);
        const double value = cosine > 0 ? light->radiance.g * cosine / light->pdf / std::numbers::pi : 0;
        sum += value;
        squares += value * value;
    }
    const double mean = sum / samples;
    return {mean, std::sqrt(std::max(0.0, squares / samples - mean * mean) / samples) + 1e-12 * mean};
}

}  // namespace raylab::lights
