// hint: overwritten
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
        const Color more = system.reflectance[j] * watts * system.form_factors.at(s, j) / system.area[j];
        radiosity[j] = more;
        unshot[j] += more;
    }
    return s;
}
