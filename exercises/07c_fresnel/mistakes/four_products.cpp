// hint: transmitted
// or: complement
// The four products of an index with a cosine give what gets through. The way back to what is reflected is forgotten.
#include "raylab/tracer/shading/fresnel.h"

#include <cmath>

double raylab::fresnel(double cosine, double ior_before, double ior_behind) {
    const double sine = ior_before / ior_behind * std::sqrt(1 - cosine * cosine);
    if (sine >= 1) return 0;
    const double behind = std::sqrt(1 - sine * sine);
    const double a = ior_before * cosine, b = ior_behind * behind, c = ior_behind * cosine, d = ior_before * behind;
    return 2 * a * b / ((a + b) * (a + b)) + 2 * c * d / ((c + d) * (c + d));
}
