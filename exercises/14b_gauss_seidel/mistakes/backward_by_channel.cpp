// hint: order
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (int c = 0; c < 3; ++c)
        for (int i = static_cast<int>(system.patches()) - 1; i >= 0; --i) {
            const auto row = static_cast<std::size_t>(i);
            double sum = 0;
            for (std::size_t j = 0; j < system.patches(); ++j)
                if (j != row) sum += system.form_factors.at(row, j) * radiosity[j][c];
            const double rho = system.reflectance[row][c];
            radiosity[row][c] = (system.emission[row][c] + rho * sum) / (1 - rho * system.form_factors.at(row, row));
        }
}
