#include "raylab/radiosity/solve/channel_groups.h"

#include <algorithm>

namespace raylab {

std::vector<std::vector<int>> channel_groups(const RadiositySystem& system) {
    std::vector<std::vector<int>> groups;
    for (int channel = 0; channel < 3; ++channel) {
        const auto has_it_too = [&](const std::vector<int>& group) {
            return std::ranges::all_of(system.reflectance,
                                       [&](const Color& rho) { return rho[channel] == rho[group.front()]; });
        };
        const auto group = std::ranges::find_if(groups, has_it_too);
        if (group == groups.end())
            groups.push_back({channel});
        else
            group->push_back(channel);
    }
    return groups;
}

}  // namespace raylab
