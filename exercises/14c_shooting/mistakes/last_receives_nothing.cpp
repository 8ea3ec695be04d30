// hint: never_receives
// or: off_by_one
// Those who receive are counted one too short.
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    std::size_t from = 0;
    double most = 0;
    for (std::size_t i = 0; i < unshot.size(); ++i) {
        const double power = system.area[i] * (unshot[i].r + unshot[i].g + unshot[i].b);
        if (power > most) most = power, from = i;
    }
    const Color power = system.area[from] * unshot[from];
    unshot[from] = Color(0);
    for (std::size_t j = 0; j < unshot.size() - 1; ++j) {
        const Color reflected = system.reflectance[j] * power * (system.form_factors.at(from, j) / system.area[j]);
        radiosity[j] += reflected;
        unshot[j] += reflected;
    }
    return from;
}
