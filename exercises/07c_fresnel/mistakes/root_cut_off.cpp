// hint: not_a_number
// The root is cut off at 0, which gives 1 but along the surface, where both cosines are 0.
#include "raylab/tracer/shading/fresnel.h"

#include <algorithm>
#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double ratio = ior_before / ior_behind;
    const double behind = std::sqrt(std::max(0.0, 1 - ratio * ratio * (1 - cosine * cosine)));
    const double across = (ratio * cosine - behind) / (ratio * cosine + behind);
    const double within = (cosine - ratio * behind) / (cosine + ratio * behind);
    return (across * across + within * within) / 2;
}
