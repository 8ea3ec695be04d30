#include "raylab/radiosity/hierarchy/link_refinement.h"

#include "raylab/scene/mean_of_channels.h"

#include <algorithm>

namespace raylab {

namespace {

// The parts of a link's error, in radiosity.
struct LinkErrors {
    double spread, hidden, variation;
    double sum() const { return spread + hidden + variation; }
};

LinkErrors errors_of(const ElementLight& light, std::uint32_t receiver, const Link& link) {
    const Color& rho = light.reflectance[receiver];
    const double reflected = std::max({rho.r, rho.g, rho.b}), sent = mean_of_channels(light.radiosity[link.source]),
                 range = light.most[link.source] - light.least[link.source];
    return {reflected * sent * link.spread, reflected * sent * link.hidden_bound, reflected * link.variation * range};
}

}  // namespace

double link_error(const ElementLight& light, std::uint32_t receiver, const Link& link) {
    return errors_of(light, receiver, link).sum();
}

Refinement refinement(const ElementTree& elements, const ElementLight& light, std::uint32_t receiver, const Link& link,
                      double allowed) {
    const LinkErrors errors = errors_of(light, receiver, link);
    if (errors.sum() <= allowed) return Refinement::none;
    const bool source_is_larger = elements[link.source].patch.area > elements[receiver].patch.area;
    const bool by_size = errors.hidden >= std::max(errors.spread, errors.variation);
    const bool source_first = by_size ? source_is_larger : errors.variation > errors.spread;
    const bool receiver_can = elements.can_be_quartered(receiver), source_can = elements.can_be_quartered(link.source);
    if (source_can && (source_first || !receiver_can)) return Refinement::quarter_source;
    return receiver_can ? Refinement::quarter_receiver : Refinement::none;
}

}  // namespace raylab
