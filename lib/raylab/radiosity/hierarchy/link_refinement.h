#pragma once

#include "raylab/radiosity/hierarchy/element_light.h"
#include "raylab/radiosity/hierarchy/link.h"

namespace raylab {

enum class Refinement { none, quarter_receiver, quarter_source };

/// How wrong the radiosity of points of the receiver may be by a link: by the form factor's spread and its error
/// bound from shadow rays, times the source's brightness; and by differences of brightness within the source.
double link_error(const ElementLight& light, std::uint32_t receiver, const Link& link);

/// Whether a link is good enough, or which of its ends is quartered: a receiver on which the form factor differs, a
/// source whose brightness does, the larger one where something may stand between. Where the chosen one is too small to
/// be quartered the other is; if both are, the link stays.
Refinement refinement(const ElementTree& elements, const ElementLight& light, std::uint32_t receiver, const Link& link,
                      double allowed);

}  // namespace raylab
