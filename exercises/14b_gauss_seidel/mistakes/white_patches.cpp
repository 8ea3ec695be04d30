// hint: reflectance_forgotten
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (int c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < system.patches(); ++i) {
            double b = system.emission[i][c];
            for (std::size_t j = 0; j < system.patches(); ++j)
                if (j != i) b += system.form_factors.at(i, j) * radiosity[j][c];
            radiosity[i][c] = b / (1 - system.form_factors.at(i, i));
        }
}
