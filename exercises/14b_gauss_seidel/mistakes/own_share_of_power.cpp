// hint: own_reflectance
// Moves only the form factor to the left side.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (int c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < radiosity.size(); ++i) {
            double b = system.emission[i][c];
            for (std::size_t j = 0; j < radiosity.size(); ++j)
                b += i == j ? 0 : system.reflectance[i][c] * system.form_factors.at(i, j) * radiosity[j][c];
            const double kept = system.form_factors.at(i, i);
            radiosity[i][c] = b / (1 - kept);
        }
}
