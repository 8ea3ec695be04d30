// hint: power_received
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    std::size_t s = 0;
    double best = 0;
    for (std::size_t i = 0; i < unshot.size(); ++i)
        if (const double watts = (unshot[i].r + unshot[i].g + unshot[i].b) * system.area[i]; watts > best) {
            s = i;
            best = watts;
        }
    const Color sent = unshot[s];
    unshot[s] = Color(0);
    for (int c = 0; c < 3; ++c)
        for (std::size_t j = 0; j < radiosity.size(); ++j) {
            const double more = system.reflectance[j][c] * sent[c] * system.area[s] * system.form_factors.at(s, j);
            radiosity[j][c] += more;
            unshot[j][c] += more;
        }
    return s;
}
