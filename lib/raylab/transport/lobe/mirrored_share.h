#pragma once

namespace raylab {

/// How a surface, or one of its facets, divides the light that it does not absorb.
enum class FacetShares {
    coefficients,  // kr is mirrored and kt refracted, at any angle
    fresnel,       // kr + kt is divided by Fresnel's equations
};

/// The shares of light that are mirrored and refracted. With total internal reflection all of it is mirrored.
struct MirroredShare {
    double mirrored, refracted;
};

/// The shares at an angle to the normal of this cosine, between these indices of refraction. What lets nothing pass
/// (kt = 0) mirrors kr.
MirroredShare mirrored_share(double kr, double kt, double cosine, double ior_here, double ior_behind,
                             FacetShares shares);

}  // namespace raylab
