#include "raylab/tracer/shading/fresnel.h"

#include <algorithm>
#include <cmath>

namespace raylab {

double fresnel(double cosine, double ior_before, double ior_behind) {
    if (!(cosine > 0)) return 1;  // grazing
    const double eta = ior_before / ior_behind;
    const double sine = eta * std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));  // behind the surface
    if (!(sine < 1)) return 1;  // NaN too: indices that leave the doubles
    const double cosine_behind = std::sqrt((1 - sine) * (1 + sine));
    // The amplitudes of light polarised perpendicular (s) and parallel (p) to the plane of incidence.
    const double r_s =
        (ior_before * cosine - ior_behind * cosine_behind) / (ior_before * cosine + ior_behind * cosine_behind);
    const double r_p =
        (ior_behind * cosine - ior_before * cosine_behind) / (ior_behind * cosine + ior_before * cosine_behind);
    return (r_s * r_s + r_p * r_p) / 2;
}

}  // namespace raylab
