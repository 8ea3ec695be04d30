#include "raylab/radiosity/solve/ambient_estimate.h"

namespace raylab {

Radiosities with_ambient_estimate(const RadiositySystem& system, std::span<const Color> radiosity,
                                  std::span<const Color> unshot) {
    double area = 0;
    Color unshot_power(0);
    Color reflecting_area(0);
    for (std::size_t i = 0; i < system.patches(); ++i) {
        area += system.area[i];
        unshot_power += system.area[i] * unshot[i];
        reflecting_area += system.area[i] * system.reflectance[i];
    }
    const Color ambient = unshot_power / (area - reflecting_area);  // (unshot / area) / (1 - mean reflectance)
    Radiosities shown(radiosity.begin(), radiosity.end());
    for (std::size_t i = 0; i < shown.size(); ++i) shown[i] += system.reflectance[i] * ambient;
    return shown;
}

}  // namespace raylab
