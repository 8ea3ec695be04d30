#pragma once

#include "raylab/report/stability.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace raylab::ray_generation {

/// A row for a method that must hold: its error is at most `most`.
inline CaseRow holds(const std::string& method, const std::string& unit, double error, double largest) {
    return {method, fmt::format("holds: off by at most {:g}{}", largest, unit),
            fmt::format("off by {:.2g}{}", error, unit), error <= largest};
}

/// A row for a weak method that must fail: if it does not, the case shows nothing.
inline CaseRow fails(const std::string& method, const std::string& unit, double error, double smallest) {
    const std::string observed = std::isfinite(error) ? fmt::format("off by {:.2g}{}", error, unit) : "not a number";
    return {method, fmt::format("fails: off by more than {:g}{}, or NaN", smallest, unit), observed,
            !(error <= smallest)};
}

}  // namespace raylab::ray_generation
