// hint: least_power
// Sorts the patches by their power, from the least on, and lets the front one shoot.
#include "raylab/radiosity/solve/shooting_step.h"

#include <algorithm>
#include <numeric>
#include <vector>

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    std::vector<std::size_t> order(system.patches());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return dot(unshot[i], Color(1)) * system.area[i]; });
    const std::size_t shooter = order.front();
    const Color watts = unshot[shooter] * system.area[shooter];
    unshot[shooter] = Color(0);
    for (std::size_t j = 0; j < system.patches(); ++j) {
        const Color arriving = watts * system.form_factors.at(shooter, j);
        const Color reflected = system.reflectance[j] * arriving / system.area[j];
        radiosity[j] += reflected;
        unshot[j] += reflected;
    }
    return shooter;
}
