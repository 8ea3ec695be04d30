// The whole row, and the patch's own part taken off again.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i) {
        const auto row = system.form_factors.row(i);
        Color arriving = -row[i] * radiosity[i];
        for (std::size_t j = 0; j < row.size(); ++j) arriving += row[j] * radiosity[j];
        radiosity[i] = (system.emission[i] + system.reflectance[i] * arriving) / (1.0 - system.reflectance[i] * row[i]);
    }
}
