// hint: reflectance
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        Color sum = system.emission[i];
        for (std::size_t j = 0; j < radiosity.size(); ++j) {
            if (i == j) continue;
            const Color sent = radiosity[j] * system.reflectance[j];
            sum += sent * system.form_factors.at(i, j);
        }
        const Color diagonal = Color(1) - system.form_factors.at(i, i) * system.reflectance[i];
        radiosity[i] = sum / diagonal;
    }
}
