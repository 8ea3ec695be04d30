// hint: emission
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (int c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < radiosity.size(); ++i) {
            double sum = 0;
            for (std::size_t j = 0; j < radiosity.size(); ++j)
                if (j != i) sum += system.reflectance[i][c] * system.form_factors.at(i, j) * radiosity[j][c];
            radiosity[i][c] = sum / (1 - system.reflectance[i][c] * system.form_factors.at(i, i));
        }
}
