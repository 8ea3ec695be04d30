// hint: never_its_turn
// Takes the end of the list for its last patch, and searches up to the one before.
#include "raylab/radiosity/solve/shooting_step.h"

#include <algorithm>
#include <vector>

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    std::vector<double> power;
    for (std::size_t i = 0; i < unshot.size(); ++i)
        power.push_back(system.area[i] * (unshot[i].r + unshot[i].g + unshot[i].b));
    const auto most = std::max_element(power.begin(), power.end() - 1);
    const auto s = static_cast<std::size_t>(most - power.begin());
    std::vector<Color> received;
    for (std::size_t j = 0; j < radiosity.size(); ++j)
        received.push_back(system.form_factors.at(j, s) * unshot[s] * system.reflectance[j]);
    unshot[s] = Color(0);
    for (std::size_t j = 0; j < radiosity.size(); ++j) {
        radiosity[j] += received[j];
        unshot[j] += received[j];
    }
    return s;
}
