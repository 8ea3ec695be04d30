#pragma once

#include "raylab/radiosity/hierarchy/element_tree.h"
#include "raylab/radiosity/radiosity_system.h"

#include <vector>

namespace raylab {

/// What elements emit, reflect and send. Emission counts at leaves only.
struct ElementLight {
    std::vector<Color> emission;  // E, with what a leaf reflects of lights and background
    std::vector<Color> reflectance;
    Radiosities radiosity;            // of an inner element the mean over its leaves' open areas
    std::vector<double> least, most;  // mean_of_channels() of its open leaves
};

/// The open area of each element: of its leaves the area times the share of their view that has patches, and 0 for
/// none. One under a box that stands on it sees nothing, is seen by nobody, and is dark. What hides it has reduced the
/// form factors to the whole already; if it darkened the mean of the whole, too, it would count twice, and closed rooms
/// would lose some hundredths of their light.
std::vector<double> open_areas(const ElementTree& elements, const std::vector<double>& open_shares);

/// Leaves reflect what arrives, and the means go up by open areas.
void pull_up(const ElementTree& elements, const std::vector<Color>& arriving, const std::vector<double>& open,
             ElementLight& light);

}  // namespace raylab
