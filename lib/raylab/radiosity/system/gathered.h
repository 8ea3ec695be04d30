#pragma once

#include "raylab/scene/scene.h"

#include <cstddef>
#include <span>

namespace raylab {

/// sum_j F_ij B_j: what arrives at patch i, per area, by its row of form factors. One pass serves all colour channels.
/// Even and odd patches are added apart, because each addition would wait for the one before; the order is always the
/// same, and so are the bits.
inline Color gathered(std::span<const double> row, std::span<const Color> radiosity) {
    Color even(0);
    Color odd(0);
    std::size_t j = 0;
    for (; j + 1 < row.size(); j += 2) {
        even += row[j] * radiosity[j];
        odd += row[j + 1] * radiosity[j + 1];
    }
    if (j < row.size()) even += row[j] * radiosity[j];
    return even + odd;
}

}  // namespace raylab
