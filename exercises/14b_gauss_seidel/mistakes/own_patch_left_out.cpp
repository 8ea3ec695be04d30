// hint: own_patch_left_out
// Leaves the patch itself out, as if it did not see itself.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i) {
        const Color& rho = system.reflectance[i];
        Color others(0);
        for (std::size_t j = 0; j < system.patches(); ++j)
            if (j != i) others += system.form_factors.at(i, j) * radiosity[j];
        radiosity[i] = system.emission[i] + rho * others;
    }
}
