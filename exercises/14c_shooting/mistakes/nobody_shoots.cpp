// hint: nothing_left
// Where nothing is left, nobody shoots, and so it is no patch's number.
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    const auto power = [&](std::size_t i) { return system.area[i] * (unshot[i].r + unshot[i].g + unshot[i].b); };
    std::size_t s = 0;
    for (std::size_t i = 1; i < system.patches(); ++i)
        if (power(i) > power(s)) s = i;
    if (power(s) == 0) return system.patches();
    const Color sent = unshot[s];
    unshot[s] = Color(0);
    for (std::size_t j = 0; j < system.patches(); ++j) {
        const double share = system.form_factors.at(s, j) * system.area[s] / system.area[j];
        const Color reflected = system.reflectance[j] * share * sent;
        radiosity[j] += reflected;
        unshot[j] += reflected;
    }
    return s;
}
