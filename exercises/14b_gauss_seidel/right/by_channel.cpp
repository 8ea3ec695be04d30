// Each channel is a system of its own.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (int channel = 0; channel < 3; ++channel)
        for (std::size_t i = 0; i < system.patches(); ++i) {
            double sum = system.emission[i][channel];
            for (std::size_t j = 0; j < system.patches(); ++j)
                if (j != i)
                    sum += system.reflectance[i][channel] * system.form_factors.at(i, j) * radiosity[j][channel];
            radiosity[i][channel] = sum / (1 - system.reflectance[i][channel] * system.form_factors.at(i, i));
        }
}
