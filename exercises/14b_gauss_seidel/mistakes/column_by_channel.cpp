// hint: row_and_column
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (int c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < system.patches(); ++i) {
            double arriving = 0;
            for (std::size_t j = 0; j < system.patches(); ++j)
                arriving += j == i ? 0 : radiosity[j][c] * system.form_factors.at(j, i);
            const double rho = system.reflectance[i][c];
            radiosity[i][c] = (system.emission[i][c] + rho * arriving) / (1 - rho * system.form_factors.at(i, i));
        }
}
