#pragma once

#include <cstddef>
#include <vector>

namespace raylab::bench {

/// y = a + b x.
struct Line {
    double a, b;
};

/// The least squares' line through the points (x, y), of which there are at least two.
inline Line line_through(const std::vector<double>& x, const std::vector<double>& y) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sx += x[i];
        sy += y[i];
        sxx += x[i] * x[i];
        sxy += x[i] * y[i];
    }
    const auto n = static_cast<double>(x.size());
    const double b = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    return {(sy - b * sx) / n, b};
}

}  // namespace raylab::bench
