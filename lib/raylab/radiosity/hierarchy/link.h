#pragma once

#include "raylab/radiosity/hierarchy/element_tree.h"
#include "raylab/radiosity/visibility.h"

#include <array>
#include <cstdint>

namespace raylab {

/// What one element, the receiver, gets from another: one form factor in place of a block of the matrix, and how much
/// of it belongs to each quarter of the source.
struct Link {
    std::uint32_t source;
    float spread;        // by how much the form factor differs between points of the receiver
    float hidden_bound;  // an error bound of the form factor, for what few shadow rays tell of what is hidden
    float variation;     // times the range of the source's brightness: how far its mean may mislead
    double factor;       // the form factor from the receiver to the source, with what hides it
    std::array<float, 4> of_quarters{1, 1, 1, 1};  // what each of the source's exchanges with the receiver, per area

    /// Elements that never see each other are not linked.
    bool exists() const { return factor > 0 || hidden_bound > 0; }
};

/// A pair of elements that may be linked.
struct LinkEnds {
    std::uint32_t receiver, source;
};

/// The link of two elements, from some points of the receiver and some shadow rays. Its hidden_bound is the whole form
/// factor where some rays pass and others are stopped, and 1 / (n + 1) of it where n agree (Laplace's rule of
/// succession).
Link estimated_link(const ElementTree& elements, const LinkEnds& ends, const PatchVisibility& visibility, int rays,
                    Traversal& traversal);

/// The same link with the form factor that it is kept with: in full view to some thousandths, since elements that touch
/// need more points than an estimate has, and times the share of other shadow rays. The estimate's rays would make
/// rooms too dark: where they happen to miss what is open, the link seems to carry little, so it is kept; where they
/// happen to miss what hides, it is refined. Nothing else of the link changes, so that what it is kept with decides
/// nothing. It gets its of_quarters, too, as if nothing hid them: places that are near each other are bright together,
/// and by the mean of its source alone a room with its front closed would lose a half more light.
Link measured_link(const ElementTree& elements, const LinkEnds& ends, const Link& estimated,
                   const PatchVisibility& visibility, int rays, Traversal& traversal);

}  // namespace raylab
