#include "raylab/sampling/mapping/lens_point.h"

#include <complex>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    // The larger of two uniform numbers is distributed as the square root of one. The halves of the square, on either
    // side of its diagonal, become the halves of the disk.
    const bool above = v > u;
    const double larger = above ? v : u, smaller = above ? u : v;
    const double within = larger > 0 ? smaller / larger : 0;  // uniform, and independent of the larger one
    const std::complex<double> point = std::polar(radius * larger, std::numbers::pi * (above ? within : 1 + within));
    return {point.real(), point.imag()};
}
