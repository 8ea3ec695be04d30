#pragma once

#include "raylab/radiosity/radiosity_view.h"

#include <cstdint>

namespace raylab {

/// How far a solution is from the truth, estimated from the solution alone.
struct PictureError {
    double relative = 0;       // root mean square over the surfaces that emit nothing, of the mean of the channels as
                               // interpolated between vertices, relative to its mean
    std::uint64_t points = 0;  // at which it was asked
    std::uint64_t rays = 0;
    double seconds = 0;
};

/// At points spread evenly over the surfaces the radiosity equation is computed once more, by a final gather. What it
/// differs by from what is shown, r, is the residual of the shown function, between the patches' centres too. The
/// error e solves e = r + K e, where K sends light once around the scene: of the part of r that is alike everywhere a
/// share a comes back with each reflection, so it counts 1 / (1 - a) times; the rest averages out. Each point gathers
/// twice with other shadow rays: the product of both differences has no share of the rays' noise in its mean.
///
/// Weak spots: a fault of a patch's brightness on which both sides of the equation agree, as that of a shadow which no
/// patch has found, is seen only where a point falls into it.
PictureError picture_error(const RadiosityView& view, int threads);

}  // namespace raylab
