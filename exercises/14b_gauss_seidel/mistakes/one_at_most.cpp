// hint: cut_off
// Cuts each radiosity off at 1, as a screen would.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

#include <glm/common.hpp>

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        Color arrives(0);
        for (std::size_t j = 0; j < radiosity.size(); ++j)
            if (j != i) arrives += system.form_factors.at(i, j) * radiosity[j];
        const Color own = system.reflectance[i] * system.form_factors.at(i, i);
        radiosity[i] = glm::min((system.emission[i] + system.reflectance[i] * arrives) / (1.0 - own), Color(1));
    }
}
