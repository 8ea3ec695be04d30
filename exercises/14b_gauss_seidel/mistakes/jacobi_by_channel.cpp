// hint: jacobi
// Collects the new radiosities and stores them at the end.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

#include <vector>

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    const std::size_t n = system.patches();
    for (int channel = 0; channel < 3; ++channel) {
        std::vector<double> fresh(n);
        for (std::size_t i = 0; i < n; ++i) {
            const double rho = system.reflectance[i][channel];
            double sum = system.emission[i][channel];
            for (std::size_t j = 0; j < n; ++j)
                if (i != j) sum += rho * system.form_factors.at(i, j) * radiosity[j][channel];
            fresh[i] = sum / (1 - rho * system.form_factors.at(i, i));
        }
        for (std::size_t i = 0; i < n; ++i) radiosity[i][channel] = fresh[i];
    }
}
