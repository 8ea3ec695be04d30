// hint: emptied_too_early
// The span of the unshot light is no copy of it.
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    const auto watts = [&](std::size_t i) { return (unshot[i].r + unshot[i].g + unshot[i].b) * system.area[i]; };
    std::size_t s = 0;
    for (std::size_t i = 1; i < unshot.size(); ++i) s = watts(i) > watts(s) ? i : s;
    const std::span<const Color> before = unshot;
    unshot[s] = Color(0);
    for (std::size_t j = 0; j < radiosity.size(); ++j) {
        const Color arriving = before[s] * system.area[s] * system.form_factors.at(s, j) / system.area[j];
        radiosity[j] += system.reflectance[j] * arriving;
        unshot[j] += system.reflectance[j] * arriving;
    }
    return s;
}
