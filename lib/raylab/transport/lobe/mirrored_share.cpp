#include "raylab/transport/lobe/mirrored_share.h"

#include "raylab/tracer/shading/fresnel.h"

namespace raylab {

MirroredShare mirrored_share(double kr, double kt, double cosine, double ior_here, double ior_behind,
                             FacetShares shares) {
    const double ratio = ior_here / ior_behind;
    if (kt == 0) return {kr, 0};
    if (!(ratio * ratio * (1 - cosine) * (1 + cosine) < 1)) return {kr + kt, 0};
    if (shares == FacetShares::coefficients) return {kr, kt};
    const double mirrored = fresnel(cosine, ior_here, ior_behind);
    return {(kr + kt) * mirrored, (kr + kt) * (1 - mirrored)};
}

}  // namespace raylab
