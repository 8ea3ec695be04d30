// hint: row_and_column
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    std::size_t s = 0;
    double most = -1;
    for (std::size_t i = 0; i < system.patches(); ++i) {
        const double watts = system.area[i] * (unshot[i].r + unshot[i].g + unshot[i].b);
        if (watts > most) most = watts, s = i;
    }
    const Color watts = unshot[s] * system.area[s];
    unshot[s] = Color(0);
    for (std::size_t j = 0; j < radiosity.size(); ++j) {
        const Color arriving = watts * system.form_factors.at(j, s);
        const Color reflected = arriving * system.reflectance[j] / system.area[j];
        radiosity[j] += reflected;
        unshot[j] += reflected;
    }
    return s;
}
