// hint: row_made_whole
// Weighs the row so that all that is sent out arrives somewhere, though the room may be open.
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    const auto power = [&](std::size_t i) { return system.area[i] * (unshot[i].r + unshot[i].g + unshot[i].b); };
    std::size_t s = 0;
    for (std::size_t i = 0; i < system.patches(); ++i)
        if (power(i) > power(s)) s = i;
    double whole = 0;
    for (const double share : system.form_factors.row(s)) whole += share;
    const Color watts = whole > 0 ? system.area[s] * unshot[s] / whole : Color(0);
    unshot[s] = Color(0);
    for (std::size_t j = 0; j < system.patches(); ++j) {
        const Color reflected = system.reflectance[j] * (system.form_factors.at(s, j) * watts / system.area[j]);
        radiosity[j] += reflected;
        unshot[j] += reflected;
    }
    return s;
}
