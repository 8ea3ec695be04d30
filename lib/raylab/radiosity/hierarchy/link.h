#pragma once

#include "raylab/radiosity/hierarchy/element_tree.h"
#include "raylab/radiosity/visibility.h"

#include <cstdint>

namespace raylab {

/// What one element, the receiver, gets from another as a whole: one number in place of a block of the matrix.
struct Link {
    std::uint32_t source;
    float spread;     // by how much the form factor differs between points of the receiver
    float doubt;      // how much of it shadow rays leave open
    float variation;  // of the range of the source's brightness: how far its mean may mislead
    double factor;    // the form factor from the receiver to the source, with what hides it

    /// Elements that never see each other are not linked.
    bool exists() const { return factor > 0 || doubt > 0; }
};

/// A pair of elements that may be linked.
struct LinkEnds {
    std::uint32_t receiver, source;
};

/// A link, and the share of its shadow rays that passed.
struct EstimatedLink {
    Link link;
    double open_share;
};

/// The link of two elements, from some points of the receiver and some shadow rays. Where some rays pass and others are
/// stopped, all of the form factor is in doubt; if n rays agree, 1 / (n + 1) of it (Laplace's rule of succession).
EstimatedLink estimated_link(const ElementTree& elements, const LinkEnds& ends, const PatchVisibility& visibility,
                             int rays, Traversal& traversal);

/// The same link with its form factor to some thousandths: the estimate tells whether a link is refined, but elements
/// that touch need more points.
Link measured_link(const ElementTree& elements, const LinkEnds& ends, const EstimatedLink& estimated);

}  // namespace raylab
