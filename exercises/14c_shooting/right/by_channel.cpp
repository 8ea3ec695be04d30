// Each channel of each patch alone; what is sent is kept before anything changes.
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    std::size_t s = 0;
    double most = -1;
    for (std::size_t i = 0; i < unshot.size(); ++i) {
        double watts = 0;
        for (int c = 0; c < 3; ++c) watts += unshot[i][c];
        watts *= system.area[i];
        if (watts > most) most = watts, s = i;
    }
    for (int c = 0; c < 3; ++c) {
        const double sent = unshot[s][c];
        unshot[s][c] = 0;
        for (std::size_t j = 0; j < radiosity.size(); ++j) {
            const double arriving = sent * (system.area[s] / system.area[j]) * system.form_factors.at(s, j);
            radiosity[j][c] += system.reflectance[j][c] * arriving;
            unshot[j][c] += system.reflectance[j][c] * arriving;
        }
    }
    return s;
}
