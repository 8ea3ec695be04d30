// hint: added
// Adds what is reflected to what left the patch before.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        Color arriving(0);
        for (std::size_t j = 0; j < radiosity.size(); ++j)
            if (j != i) arriving += system.form_factors.at(i, j) * radiosity[j];
        const Color reflected = system.reflectance[i] * arriving;
        radiosity[i] += reflected / (1.0 - system.reflectance[i] * system.form_factors.at(i, i));
    }
}
