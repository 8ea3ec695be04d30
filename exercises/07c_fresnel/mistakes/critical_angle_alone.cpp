// hint: angle_forgotten
// The angle decides whether all is reflected, and after that it is not asked again.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double n = ior_behind / ior_before;
    const bool is_total = n <= 1 && std::acos(cosine) >= std::asin(n);
    return is_total ? 1 : std::pow((n - 1) / (n + 1), 2);
}
