// hint: area_ratio
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    std::size_t s = 0;
    double most = -1;
    for (std::size_t i = 0; i < system.patches(); ++i) {
        const double watts = system.area[i] * (unshot[i].r + unshot[i].g + unshot[i].b);
        if (watts > most) most = watts, s = i;
    }
    const Color out = unshot[s];
    unshot[s] = {};
    for (std::size_t j = 0; j < system.patches(); ++j)
        for (int channel = 0; channel < 3; ++channel) {
            const double b = system.reflectance[j][channel] * out[channel] * system.form_factors.at(s, j);
            radiosity[j][channel] += b;
            unshot[j][channel] += b;
        }
    return s;
}
