// hint: channels
// The red reflectance for all channels.
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    std::size_t shooter = 0;
    double most = 0;
    for (std::size_t i = 0; i < unshot.size(); ++i) {
        const double watts = system.area[i] * glm::dot(unshot[i], Color(1));
        if (watts <= most) continue;
        most = watts;
        shooter = i;
    }
    const Color sent = unshot[shooter];
    unshot[shooter] = Color(0);
    for (std::size_t j = 0; j < system.patches(); ++j) {
        const double share = system.form_factors.at(shooter, j) * system.area[shooter] / system.area[j];
        const Color reflected = system.reflectance[j].r * share * sent;
        radiosity[j] += reflected;
        unshot[j] += reflected;
    }
    return shooter;
}
