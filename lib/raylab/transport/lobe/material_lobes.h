#pragma once

#include "raylab/transport/lobe/lobe.h"

#include <array>
#include <cstddef>
#include <span>

namespace raylab {

/// What a surface is between: the indices of refraction on the side of wo and on the other.
struct Interface {
    double ior_here = 1, ior_behind = 1;
};

/// A surface's ways to scatter light, taken apart: the lobes that spread it, and the shares of the sharp directions,
/// which are no lobes: no density reaches them.
struct MaterialLobes {
    double mirrored = 0, refracted = 0;  // sharp: kr, and kt where light can be refracted

    std::span<const Lobe> spread() const { return {lobes_.data(), count_}; }
    void add(const Lobe& lobe) { lobes_[count_++] = lobe; }

private:
    std::array<Lobe, 3> lobes_{};  // diffuse, mirrored, refracted: in place, since every hit asks for them
    std::size_t count_ = 0;
};

/// What a material does with light that leaves in direction wo. `diffuse` is its diffuse colour at the point.
MaterialLobes material_lobes(const Material& material, const Color& diffuse, const Vec3d& wo,
                             const Interface& interface, FacetShares shares = FacetShares::coefficients);

}  // namespace raylab
