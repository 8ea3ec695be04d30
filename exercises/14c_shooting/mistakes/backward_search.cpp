// hint: last_of_equals
#include "raylab/radiosity/solve/shooting_step.h"

std::size_t raylab::shooting_step(const RadiositySystem& system, std::span<Color> radiosity, std::span<Color> unshot) {
    const auto watts = [&](std::size_t i) { return (unshot[i].r + unshot[i].g + unshot[i].b) * system.area[i]; };
    std::size_t s = system.patches() - 1;
    for (std::size_t i = s; i-- > 0;)
        if (watts(i) > watts(s)) s = i;
    const Color sent = unshot[s];
    unshot[s] = Color(0);
    for (std::size_t j = 0; j < radiosity.size(); ++j) {
        const Color more = system.reflectance[j] * system.form_factors.at(j, s) * sent;
        radiosity[j] += more;
        unshot[j] += more;
    }
    return s;
}
