// hint: by_radiosity
#include "raylab/radiosity/solve/shooting_step.h"

#include <algorithm>

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    const auto light = [](const Color& color) { return color.r + color.g + color.b; };
    const auto s = static_cast<std::size_t>(std::ranges::max_element(radiosity, {}, light) - radiosity.begin());
    const Color sent = unshot[s];
    unshot[s] = Color(0);
    for (std::size_t j = 0; j < radiosity.size(); ++j) {
        const Color more = system.reflectance[j] * system.form_factors.at(j, s) * sent;
        radiosity[j] += more;
        unshot[j] += more;
    }
    return s;
}
