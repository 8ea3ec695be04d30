// hint: reflectance_in_choice
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    std::size_t s = 0;
    auto w = [&](std::size_t i) {
        Color c = unshot[i] * system.reflectance[i];
        return system.area[i] * (c.r + c.g + c.b);
    };
    for (std::size_t i = 1; i < unshot.size(); ++i)
        if (w(i) > w(s)) s = i;
    Color shot = unshot[s];
    unshot[s] = Color(0);
    for (std::size_t j = 0; j < unshot.size(); ++j) {
        Color d = system.reflectance[j] * system.form_factors.at(j, s) * shot;
        radiosity[j] += d;
        unshot[j] += d;
    }
    return s;
}
