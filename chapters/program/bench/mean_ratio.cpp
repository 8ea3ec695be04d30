#include "mean_ratio.h"

#include <fmt/format.h>

#include <cmath>

namespace raylab::bench {

std::optional<double> mean_ratio(const std::vector<Row>& rows, const Racer& one, const Racer& base,
                                 const Quantity& quantity, const Counts& counts) {
    double sum = 0;
    int count = 0;
    for (const Row& row : rows) {
        if (racer(row) != one || !counts(row)) continue;
        for (const Row& other : rows) {
            if (racer(other) != base || other.mesh != row.mesh || other.rays != row.rays) continue;
            sum += std::log(quantity(row) / quantity(other));
            ++count;
        }
    }
    return count > 0 ? std::optional(std::exp(sum / count)) : std::nullopt;
}

std::string ratio_text(std::optional<double> ratio) {
    if (!ratio) return "";
    return *ratio < 0.095 ? fmt::format("{:.2g}", *ratio) : fmt::format("{:.2f}", *ratio);
}

}  // namespace raylab::bench
