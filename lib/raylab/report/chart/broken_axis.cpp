#include "raylab/report/chart/broken_axis.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

/// The index of the first value beyond the break; the number of values where there is no break.
std::size_t break_in(const std::vector<double>& sorted) {
    std::size_t found = sorted.size();
    double widest = 0;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        const double gap = std::log10(sorted[i] / sorted[i - 1]);
        if (gap > widest) widest = gap, found = i;
    }
    const bool wide = widest > 1 && widest > std::log10(sorted.back() / sorted.front()) / 3;
    const bool few = 5 * (sorted.size() - found) <= sorted.size();
    return wide && few ? found : sorted.size();
}

}  // namespace

std::vector<const AxisScale*> BrokenAxis::scales() const {
    if (!beyond) return {&main};
    return {&main, &*beyond};
}

double BrokenAxis::share(double value) const {
    if (!beyond) return main.share(value);
    if (value <= main.high) return main_share * main.share(value);
    return std::lerp(main_share + gap_share, 1.0, beyond->share(value));
}

BrokenAxis broken_axis_for(std::vector<double> values, double margin) {
    std::erase_if(values, [](double value) { return !(std::isfinite(value) && value > 0); });
    std::ranges::sort(values);
    const auto at = values.empty() ? 0 : break_in(values);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(at);
    BrokenAxis axis{axis_for({values.begin(), middle}, AxisKind::logarithmic, margin), std::nullopt};
    if (middle != values.end()) axis.beyond = axis_for({middle, values.end()}, AxisKind::logarithmic, 0.25);
    return axis;
}

}  // namespace raylab
