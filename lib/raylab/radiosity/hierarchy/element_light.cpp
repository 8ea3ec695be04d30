#include "raylab/radiosity/hierarchy/element_light.h"

#include "raylab/scene/mean_of_channels.h"

#include <algorithm>
#include <limits>

namespace raylab {

std::vector<double> open_areas(const ElementTree& elements, const std::vector<double>& open_shares) {
    std::vector<double> open(elements.size());
    for (std::size_t i = elements.size(); i-- > 0;) {
        const Element& element = elements[i];
        if (element.is_leaf()) open[i] = element.patch.area * open_shares[i];
        if (element.parent != i) open[element.parent] += open[i];
    }
    return open;
}

namespace {

// The light of an element from that of its quarters, each as much as its open area is of theirs.
void pull_from_quarters(const Element& element, const std::vector<double>& open, std::size_t into,
                        ElementLight& light) {
    Color sum(0);
    double area = 0, least = std::numeric_limits<double>::infinity(), most = 0;
    for (std::size_t child = element.first_child; child < element.first_child + 4; ++child) {
        if (open[child] == 0) continue;
        sum += open[child] * light.radiosity[child];
        area += open[child];
        least = std::min(least, light.least[child]);
        most = std::max(most, light.most[child]);
    }
    light.radiosity[into] = area > 0 ? sum / area : Color(0);
    light.least[into] = area > 0 ? least : 0;
    light.most[into] = most;
}

}  // namespace

void pull_up(const ElementTree& elements, const std::vector<Color>& arriving, const std::vector<double>& open,
             ElementLight& light) {
    for (std::size_t i = elements.size(); i-- > 0;) {
        if (!elements[i].is_leaf()) {
            pull_from_quarters(elements[i], open, i, light);
        } else {
            light.radiosity[i] = light.emission[i] + light.reflectance[i] * arriving[i];
            light.least[i] = light.most[i] = mean_of_channels(light.radiosity[i]);
        }
    }
}

}  // namespace raylab
