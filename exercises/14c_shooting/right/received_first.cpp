// What all receive is computed first, and then booked.
#include "raylab/radiosity/solve/shooting_step.h"

#include <algorithm>
#include <functional>
#include <vector>

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    std::vector<double> power;
    for (std::size_t i = 0; i < unshot.size(); ++i) power.push_back(dot(unshot[i], Color(1)) * system.area[i]);
    const auto s = static_cast<std::size_t>(std::ranges::max_element(power) - power.begin());
    std::vector<Color> received;
    for (std::size_t j = 0; j < radiosity.size(); ++j)
        received.push_back(system.form_factors.at(j, s) * unshot[s] * system.reflectance[j]);
    unshot[s] = Color(0);
    std::ranges::transform(radiosity, received, radiosity.begin(), std::plus<>());
    std::ranges::transform(unshot, received, unshot.begin(), std::plus<>());
    return s;
}
