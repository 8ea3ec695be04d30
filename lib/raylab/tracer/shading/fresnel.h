#pragma once

namespace raylab {

/// The share of unpolarised light that a smooth surface between two media reflects; 1 under total internal reflection.
/// `cosine` is that of the angle of incidence, from 0 to 1, on the side of `ior_before`.
double fresnel(double cosine, double ior_before, double ior_behind);

}  // namespace raylab
