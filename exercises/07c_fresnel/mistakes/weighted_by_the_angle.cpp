// hint: mean
// The nearer to the normal the light arrives, the more the first polarisation counts.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double sine = ior_before / ior_behind * std::sqrt((1 - cosine) * (1 + cosine));
    if (sine >= 1) return 1;
    const double behind = std::sqrt((1 - sine) * (1 + sine));
    const double s = (ior_before * cosine - ior_behind * behind) / (ior_before * cosine + ior_behind * behind);
    const double p = (ior_behind * cosine - ior_before * behind) / (ior_behind * cosine + ior_before * behind);
    return cosine * cosine * s * s + (1 - cosine * cosine) * p * p;
}
