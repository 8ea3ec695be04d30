#include "raylab/tracer/fresnel.h"

#include <cmath>

namespace raylab {

double fresnel(double cosine, double ior_before, double ior_behind) {
    if (!(cosine > 0)) return 1;  // grazing
    const double eta = ior_before / ior_behind;
    const double square = 1 - eta * eta * (1 - cosine * cosine);
    if (square < 0) return 1;
    const double cosine_behind = std::sqrt(square);
    const double across = (ior_before * cosine - ior_behind * cosine_behind) / (ior_before * cosine + ior_behind * cosine_behind);
    const double along = (ior_behind * cosine - ior_before * cosine_behind) / (ior_behind * cosine + ior_before * cosine_behind);
    return (across * across + along * along) / 2;
}

}  // namespace raylab
