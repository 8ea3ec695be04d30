// hint: channels
// The mean of the three reflectances for all channels.
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    const auto power = [&](std::size_t i) { return system.area[i] * (unshot[i].r + unshot[i].g + unshot[i].b); };
    const auto mean = [](const Color& c) { return (c.r + c.g + c.b) / 3; };
    std::size_t shooter = 0;
    for (std::size_t i = 1; i < system.patches(); ++i)
        if (power(i) > power(shooter)) shooter = i;
    const Color sent = unshot[shooter];
    unshot[shooter] = Color(0);
    for (std::size_t j = 0; j < system.patches(); ++j) {
        const double share = system.form_factors.at(shooter, j) * system.area[shooter] / system.area[j];
        const Color reflected = mean(system.reflectance[j]) * share * sent;
        radiosity[j] += reflected;
        unshot[j] += reflected;
    }
    return shooter;
}
