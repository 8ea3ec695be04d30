// hint: emptied_too_early
// What patches receive is added to copies.
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    const auto power = [&](std::size_t i) { return system.area[i] * (unshot[i].r + unshot[i].g + unshot[i].b); };
    std::size_t s = 0;
    for (std::size_t i = 1; i < system.patches(); ++i)
        if (power(i) > power(s)) s = i;
    const Color sent = unshot[s] * system.area[s];
    unshot[s] = Color(0);
    for (std::size_t j = 0; j < system.patches(); ++j) {
        Color all = radiosity[j], left = unshot[j];
        const Color reflected = system.reflectance[j] * (system.form_factors.at(s, j) / system.area[j]) * sent;
        all += reflected;
        left += reflected;
    }
    return s;
}
