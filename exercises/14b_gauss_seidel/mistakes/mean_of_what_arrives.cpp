// hint: row_made_whole
// A weighted mean of the others' radiosities, not their sum.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        const double own = system.form_factors.at(i, i);
        Color seen = -own * radiosity[i];
        double weights = -own;
        for (std::size_t j = 0; j < radiosity.size(); ++j) {
            seen += system.form_factors.at(i, j) * radiosity[j];
            weights += system.form_factors.at(i, j);
        }
        const Color mean = seen / weights;
        radiosity[i] = (system.emission[i] + system.reflectance[i] * mean) / (1.0 - own * system.reflectance[i]);
    }
}
