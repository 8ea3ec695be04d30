#include "raylab/radiosity/hierarchy/hierarchical_power.h"

#include "raylab/radiosity/direct_light.h"

namespace raylab {

PowerBalance hierarchical_power(const HierarchicalRadiosity& solved, int threads) {
    const ElementLight& light = solved.light;
    const auto gathered = gathered_light(solved.elements, solved.links, solved.open, light.radiosity, threads);
    PowerBalance power;
    for (std::size_t i = 0; i < solved.elements.size(); ++i) {
        if (!solved.elements[i].is_leaf()) continue;
        const double area = solved.elements[i].patch.area;
        const Color background = background_light({solved.open[i] / area, solved.background[i]}, solved.filled[i]);
        power.emitted += area * (light.emission[i] + light.reflectance[i] * background);
        power.absorbed += area * (1.0 - light.reflectance[i]) * gathered[i];
        power.lost += area * (light.radiosity[i] - gathered[i]);
    }
    return with_imbalance(power);
}

}  // namespace raylab
