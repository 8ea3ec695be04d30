// Power is conserved: what the shooter sends is divided among the areas that it reaches.
#include "raylab/radiosity/solve/shooting_step.h"

#include <algorithm>
#include <vector>

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    std::vector<double> power;
    for (std::size_t i = 0; i < system.patches(); ++i)
        power.push_back((unshot[i].r + unshot[i].g + unshot[i].b) * system.area[i]);
    const auto shooter = static_cast<std::size_t>(std::ranges::max_element(power) - power.begin());
    const Color watts = unshot[shooter] * system.area[shooter];
    unshot[shooter] = {};
    for (std::size_t j = 0; j < system.patches(); ++j) {
        const Color arriving = watts * system.form_factors.at(shooter, j);
        const Color reflected = system.reflectance[j] * arriving / system.area[j];
        radiosity[j] += reflected;
        unshot[j] += reflected;
    }
    return shooter;
}
