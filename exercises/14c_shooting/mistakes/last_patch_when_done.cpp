// hint: nothing_left
// or: last_of_equals
// Begins with the last patch, and so keeps it where no other has more.
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    double most = 0;
    std::size_t s = system.patches() - 1;
    for (std::size_t i = 0; i < system.patches(); ++i) {
        const double power = (unshot[i].r + unshot[i].g + unshot[i].b) * system.area[i];
        if (power > most) {
            most = power;
            s = i;
        }
    }
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
