// hint: degrees
#include "raylab/sampling/mapping/lens_point.h"

#include <complex>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    const auto point = std::polar(radius * std::sqrt(v), 360 * u);
    return {point.imag(), point.real()};
}
