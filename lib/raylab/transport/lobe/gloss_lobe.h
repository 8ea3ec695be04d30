#pragma once

#include "raylab/transport/lobe/lobe_sample.h"

#include <array>
#include <optional>

namespace raylab {

/// Phong's lobe, made reciprocal and normalised: f = k (n + 2) / (2 pi) cos^n of the angle between wi and `axis`, and
/// zero on the other side of the surface than the axis. So it keeps k of the light that falls straight on it, and less
/// at a slant, where a part of the lobe is cut off. (Lafortune and Willems, "Using the Modified Phong Reflectance Model
/// for Physically Based Rendering", 1994.)
struct GlossLobe {
    double k;         // kr or kt
    double exponent;  // n
    Vec3d axis;       // the mirrored or the refracted direction of wo, unit

    Color value(const Vec3d& wo, const Vec3d& wi) const;
    double pdf(const Vec3d& wo, const Vec3d& wi) const;
    /// Absent where the direction would lie on the wrong side: that light is lost.
    std::optional<LobeSample> sample(const Vec3d& wo, const std::array<double, 2>& numbers) const;
};

/// The direction that a mirror with normal z gives to light seen from wo.
inline Vec3d mirrored_about_z(const Vec3d& wo) { return {-wo.x, -wo.y, wo.z}; }

}  // namespace raylab
