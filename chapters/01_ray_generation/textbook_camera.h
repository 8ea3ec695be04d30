#pragma once

#include "raylab/geometry/vector.h"

#include <cmath>
#include <numbers>

namespace raylab::ray_generation {

/// The camera by the README's formulas, in the number type T and without further care; the stability cases compare it
/// with camera_frame().
template <Real T>
struct TextbookCamera {
    Vec3<T> eye, right, up, forward;
    T half_height;

    TextbookCamera(const Vec3d& position, const Vec3d& target, const Vec3d& up_hint, double fov_y)
        : eye(convert<T>(position)),
          right(),
          up(),
          forward(unit(convert<T>(target) - eye)),
          half_height(std::tan(cast<T>(fov_y) / 2 * std::numbers::pi_v<T> / 180)) {
        right = unit(cross(forward, convert<T>(up_hint)));
        up = cross(right, forward);
    }

    static Vec3<T> unit(const Vec3<T>& v) {
        const T length = std::sqrt(dot(v, v));
        return {v.x / length, v.y / length, v.z / length};
    }

    /// The direction to the point (across, upward) of a square picture, each from -1 to 1.
    Vec3<T> direction(T across, T upward) const {
        return unit(forward + across * half_height * right + upward * half_height * up);
    }
};

/// How far three vectors are from an orthonormal frame: the largest entry of F F^T - 1, in double; NaN where any of
/// them is.
template <class Frame>
double unsquareness(const Frame& frame) {
    const Vec3d axes[] = {convert<double>(frame.right), convert<double>(frame.up), convert<double>(frame.forward)};
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
            const double off = std::abs(dot(axes[i], axes[j]) - (i == j ? 1 : 0));
            if (!(off <= worst)) worst = off;
        }
    return worst;
}

}  // namespace raylab::ray_generation
