#include "raylab/radiosity/solve/residual.h"

#include "raylab/radiosity/system/for_each_row.h"
#include "raylab/radiosity/system/gathered.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

double magnitude(double value) { return std::isnan(value) ? std::numeric_limits<double>::infinity() : std::abs(value); }

Color larger(const Color& largest, const Color& value) {
    return {std::max(largest.r, magnitude(value.r)), std::max(largest.g, magnitude(value.g)),
            std::max(largest.b, magnitude(value.b))};
}

}  // namespace

Color largest_of(std::span<const Color> values) {
    Color largest(0);
    for (const Color& value : values) largest = larger(largest, value);
    return largest;
}

Color largest_change(std::span<const Color> before, std::span<const Color> after) {
    Color largest(0);
    for (std::size_t i = 0; i < before.size(); ++i) largest = larger(largest, after[i] - before[i]);
    return largest;
}

double relative(const Color& error, const Color& largest) {
    double quotient = 0;
    for (int channel = 0; channel < 3; ++channel)
        if (error[channel] > 0) quotient = std::max(quotient, magnitude(error[channel] / largest[channel]));
    return quotient;
}

Color residual_of(const RadiositySystem& system, std::span<const Color> radiosity, int threads) {
    std::vector<Color> residuals(system.patches());
    for_each_row(system.patches(), threads, [&](std::size_t i) {
        const Color arriving = gathered(system.form_factors.row(i), radiosity);
        residuals[i] = system.emission[i] + system.reflectance[i] * arriving - radiosity[i];
    });
    return largest_of(residuals);
}

}  // namespace raylab
