// hint: reflectance_forgotten
// What is left to shoot grows by all that arrives, and not by what is reflected.
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    const auto power = [&](std::size_t i) { return system.area[i] * glm::dot(unshot[i], Color(1)); };
    std::size_t shooter = 0;
    for (std::size_t i = 1; i < system.patches(); ++i)
        if (power(i) > power(shooter)) shooter = i;
    const Color sent = system.area[shooter] * unshot[shooter];
    unshot[shooter] = Color(0);
    for (std::size_t j = 0; j < system.patches(); ++j) {
        const Color arriving = system.form_factors.at(shooter, j) * sent / system.area[j];
        unshot[j] += arriving;
        radiosity[j] += arriving * system.reflectance[j];
    }
    return shooter;
}
