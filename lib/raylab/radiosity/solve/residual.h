#pragma once

#include "raylab/radiosity/radiosity_system.h"

#include <span>

namespace raylab {

/// The largest magnitude of each channel; 0 of no patches. A value that is not a number counts as infinite.
Color largest_of(std::span<const Color> values);

/// The largest change of each channel.
Color largest_change(std::span<const Color> before, std::span<const Color> after);

/// The largest of the channels' quotients, of magnitudes; a channel in which all is 0 has 0.
double relative(const Color& error, const Color& largest);

/// max_i |E_i + rho_i sum_j F_ij B_j - B_i|, in each channel.
Color residual_of(const RadiositySystem& system, std::span<const Color> radiosity, int threads);

}  // namespace raylab
