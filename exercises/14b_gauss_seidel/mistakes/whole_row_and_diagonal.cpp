// hint: own_patch_twice
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

#include <numeric>

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < system.patches(); ++i) {
        const auto row = system.form_factors.row(i);
        const Color arriving =
            std::inner_product(radiosity.begin(), radiosity.end(), row.begin(), Color(0), std::plus<>(),
                               [](const Color& b, double share) { return share * b; });
        const Color diagonal = 1.0 - system.reflectance[i] * row[i];
        radiosity[i] = (system.reflectance[i] * arriving + system.emission[i]) / diagonal;
    }
}
