// hint: all_radiosity
// What a patch emits is sent out at each of its turns.
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    const auto power = [&](std::size_t i) { return system.area[i] * (unshot[i].r + unshot[i].g + unshot[i].b); };
    std::size_t shooter = 0;
    for (std::size_t i = 1; i < system.patches(); ++i)
        if (power(i) > power(shooter)) shooter = i;
    const Color sent = unshot[shooter] + system.emission[shooter];
    unshot[shooter] = Color(0);
    for (std::size_t j = 0; j < system.patches(); ++j) {
        const double share = system.form_factors.at(shooter, j) * system.area[shooter] / system.area[j];
        const Color reflected = system.reflectance[j] * share * sent;
        radiosity[j] += reflected;
        unshot[j] += reflected;
    }
    return shooter;
}
