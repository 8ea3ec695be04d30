// hint: two_sweeps
// A sweep from the first patch to the last, and one back again.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    const auto visit = [&](std::size_t i) {
        Color sum(0);
        for (std::size_t j = 0; j < radiosity.size(); ++j)
            if (j != i) sum += system.form_factors.at(i, j) * radiosity[j];
        const Color& rho = system.reflectance[i];
        radiosity[i] = (system.emission[i] + rho * sum) / (1.0 - rho * system.form_factors.at(i, i));
    };
    for (std::size_t i = 0; i < radiosity.size(); ++i) visit(i);
    for (std::size_t i = radiosity.size(); i > 0; --i) visit(i - 1);
}
