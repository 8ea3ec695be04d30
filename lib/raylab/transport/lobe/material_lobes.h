#pragma once

#include "raylab/transport/lobe/lobe.h"

#include <boost/container/static_vector.hpp>

#include <cstddef>

namespace raylab {

/// What a surface is between: the indices of refraction on the side of wo and on the other.
struct Interface {
    double ior_here = 1, ior_behind = 1;
};

/// A surface's ways to scatter light, taken apart: at most so many lobes that spread it, and the shares of the sharp
/// directions, which are no lobes: no density reaches them.
template <class AnyLobe, std::size_t most>
struct LobesOf {
    double mirrored = 0, refracted = 0;  // sharp: kr, and kt where light can be refracted

    // Diffuse, mirrored, refracted. In place, and none is made that is not added, since every hit asks for them.
    boost::container::static_vector<AnyLobe, most> spread;
};

using MaterialLobes = LobesOf<Lobe, 3>;

/// What a material without gloss and roughness does with light that leaves in direction wo. `diffuse` is its diffuse
/// colour at the point.
template <class Lobes>
Lobes sharp_lobes(const Material& material, const Color& diffuse, const Vec3d& wo, const Interface& interface,
                  FacetShares shares) {
    Lobes lobes;
    if (diffuse != Color(0)) lobes.spread.push_back(DiffuseLobe{diffuse});
    if (material.kr == 0 && material.kt == 0) return lobes;
    const auto [mirrored, refracted] =
        mirrored_share(material.kr, material.kt, wo.z, interface.ior_here, interface.ior_behind, shares);
    lobes.mirrored = mirrored;
    lobes.refracted = refracted;
    return lobes;
}

/// What one with gloss or roughness does.
MaterialLobes polished_lobes(const Material& material, const Color& diffuse, const Vec3d& wo,
                             const Interface& interface, FacetShares shares);

/// What any material does.
inline MaterialLobes material_lobes(const Material& material, const Color& diffuse, const Vec3d& wo,
                                    const Interface& interface, FacetShares shares = FacetShares::coefficients) {
    if (std::holds_alternative<Sharp>(material.polish)) [[likely]]
        return sharp_lobes<MaterialLobes>(material, diffuse, wo, interface, shares);
    return polished_lobes(material, diffuse, wo, interface, shares);
}

}  // namespace raylab
