#pragma once

#include "raylab/geometry/vector.h"

#include <cstdint>
#include <functional>
#include <span>

namespace raylab {

/// How pairs of points, one on either polygon, are chosen.
enum class PairPattern {
    random,           // anywhere
    jittered,         // one in each cell of a grid of the four dimensions
    low_discrepancy,  // by the additive sequence of Roberts (R4, 2018), with a random shift
};

struct AreaSampling {
    int pairs = 256;  // rounded up to `batches` equal grids or runs
    PairPattern pattern = PairPattern::low_discrepancy;
    std::uint64_t seed = 1;

    /// The pairs come in batches that do not depend on one another; the scatter of their means tells the error.
    static constexpr int batches = 16;
};

/// An estimate with its standard error: the truth is within four of them, but for one case in a thousand.
struct SampledFormFactor {
    double value, standard_error;
    int pairs;
};

/// How much of the light on the way from one point to another arrives there: 0 or 1, or a share.
using PointVisibility = std::function<double(const Vec3d& from, const Vec3d& to)>;

/// The form factor from one convex polygon to another as a mean over pairs of points. Weak spot: polygons that touch,
/// where the density has no bound and neither has the variance.
SampledFormFactor sampled_form_factor(std::span<const Vec3d> from, std::span<const Vec3d> to,
                                      const AreaSampling& sampling, const PointVisibility& visible);

}  // namespace raylab
