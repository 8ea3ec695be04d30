#include "raylab/radiosity/system/power_balance.h"

#include "raylab/radiosity/system/for_each_row.h"
#include "raylab/radiosity/system/gathered.h"
#include "raylab/radiosity/system/row_sums.h"

#include <cmath>
#include <vector>

namespace raylab {

PowerBalance with_imbalance(PowerBalance power) {
    power.imbalance = 0;
    for (int channel = 0; channel < 3; ++channel) {
        if (!(power.emitted[channel] > 0)) continue;
        const double left = power.emitted[channel] - power.absorbed[channel] - power.lost[channel];
        if (std::abs(left) > std::abs(power.imbalance) * power.emitted[channel])
            power.imbalance = left / power.emitted[channel];
    }
    return power;
}

PowerBalance power_balance(const RadiositySystem& system, std::span<const Color> radiosity, int threads) {
    const std::vector<double> sums = each_row_sum(system.form_factors, threads);
    std::vector<Color> arriving(system.patches());
    for_each_row(system.patches(), threads,
                 [&](std::size_t i) { arriving[i] = gathered(system.form_factors.row(i), radiosity); });
    PowerBalance power;
    for (std::size_t i = 0; i < system.patches(); ++i) {
        power.emitted += system.area[i] * system.emission[i];
        power.absorbed += system.area[i] * (1.0 - system.reflectance[i]) * arriving[i];
        power.lost += system.area[i] * (1 - sums[i]) * radiosity[i];
    }
    return with_imbalance(power);
}

}  // namespace raylab
