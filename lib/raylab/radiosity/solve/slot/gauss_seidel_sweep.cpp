#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

#include "raylab/radiosity/system/gathered.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i) {
        const auto row = system.form_factors.row(i);
        const Color from_others = gathered(row, radiosity) - row[i] * radiosity[i];
        const Color& reflectance = system.reflectance[i];
        radiosity[i] = (system.emission[i] + reflectance * from_others) / (1.0 - reflectance * row[i]);
    }
}
