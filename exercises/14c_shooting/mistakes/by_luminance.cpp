// hint: by_red
// Chooses by how bright the eye finds it.
#include "raylab/radiosity/solve/shooting_step.h"

#include <vector>

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    std::size_t s = 0;
    std::vector<double> weight;
    for (std::size_t i = 0; i < unshot.size(); ++i) {
        const Color& c = unshot[i];
        weight.push_back((0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b) * system.area[i]);
        if (weight[i] > weight[s]) s = i;
    }
    const Color sent = unshot[s] * system.area[s];
    unshot[s] = Color(0);
    for (std::size_t j = 0; j < radiosity.size(); ++j) {
        const Color more = system.reflectance[j] * (system.form_factors.at(s, j) * sent / system.area[j]);
        radiosity[j] += more;
        unshot[j] += more;
    }
    return s;
}
