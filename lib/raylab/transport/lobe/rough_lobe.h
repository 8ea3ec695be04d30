#pragma once

#include "raylab/transport/lobe/lobe_sample.h"
#include "raylab/transport/lobe/mirrored_share.h"

#include <array>
#include <optional>

namespace raylab {

/// A rough surface: each microscopic facet mirrors and refracts sharply, and GGX says how many face where (Walter,
/// Marschner, Li and Torrance 2007). Where a facet cannot refract (total internal reflection), it mirrors kr + kt.
/// Light between facets is lost, so a very rough surface is somewhat dark. As in Whitted's model, radiance is not
/// multiplied by the squared ratio of the indices of refraction.
struct RoughLobe {
    double kr, kt;
    double alpha;                 // roughness^2, in (0, 1]
    double ior_here, ior_behind;  // on the side of wo and on the other
    FacetShares shares = FacetShares::coefficients;

    Color value(const Vec3d& wo, const Vec3d& wi) const;
    double pdf(const Vec3d& wo, const Vec3d& wi) const;
    /// Absent where the direction would lie on the wrong side: that light is lost.
    std::optional<LobeSample> sample(const Vec3d& wo, const std::array<double, 2>& numbers) const;
};

}  // namespace raylab
