// hint: brightest
#include "raylab/radiosity/solve/shooting_step.h"

#include <algorithm>

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    const auto light = [](const Color& color) { return color.r + color.g + color.b; };
    const auto most = std::ranges::max_element(unshot, {}, light);
    const auto s = static_cast<std::size_t>(most - unshot.begin());
    const Color watts = unshot[s] * system.area[s];
    unshot[s] = Color(0);
    for (std::size_t j = 0; j < radiosity.size(); ++j) {
        const Color more = system.reflectance[j] * watts * system.form_factors.at(s, j) / system.area[j];
        radiosity[j] += more;
        unshot[j] += more;
    }
    return s;
}
