// hint: row_and_column
// Sums up what arrives once; what a patch has changed by is then handed on by the share that it sends, not receives.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

#include <vector>

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    const auto patches = system.patches();
    const auto& share = system.form_factors;
    std::vector<Color> received;
    for (std::size_t i = 0; i < patches; ++i) {
        Color sum = -share.at(i, i) * radiosity[i];
        for (std::size_t j = 0; j < patches; ++j) sum += share.at(i, j) * radiosity[j];
        received.push_back(sum);
    }
    for (std::size_t i = 0; i < patches; ++i) {
        const Color old = radiosity[i];
        radiosity[i] =
            (system.emission[i] + system.reflectance[i] * received[i]) / (1.0 - system.reflectance[i] * share.at(i, i));
        for (std::size_t j = i + 1; j < patches; ++j) received[j] += share.at(i, j) * (radiosity[i] - old);
    }
}
