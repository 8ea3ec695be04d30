// hint: added
// Each channel alone; what is solved for is put on top of what is there, as in a solver that adds what is missing.
#include "raylab/radiosity/solve/gauss_seidel_sweep.h"

void raylab::gauss_seidel_sweep(const RadiositySystem& system, std::span<Color> radiosity) {
    for (int channel = 0; channel < 3; ++channel)
        for (std::size_t i = 0; i < radiosity.size(); ++i) {
            const auto row = system.form_factors.row(i);
            double arriving = -row[i] * radiosity[i][channel];
            for (std::size_t j = 0; j < row.size(); ++j) arriving += row[j] * radiosity[j][channel];
            const double rho = system.reflectance[i][channel];
            const double leaving = system.emission[i][channel] + rho * arriving;
            radiosity[i][channel] += leaving / (1 - rho * row[i]);
        }
}
