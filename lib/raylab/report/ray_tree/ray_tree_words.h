#pragma once

#include "raylab/tracer/whitted/ray_tree.h"

// Ray trees in words, for labels, tooltips and terminals.

namespace raylab {

/// A colour with a few digits: "0.3 0.25 0.1".
std::string in_words(const Color& color);

/// The reason why a branch ends, as a sentence without its full stop; empty for Ending::branched.
std::string why_it_ended(Ending ending);

/// What a ray hit: "sphere 3 at t = 2.41", "background", "light 0: blocked"; for a branch that was cut, the reason.
std::string what_it_hit(const RayNode& node);

/// Everything that is known about a node, one line for each fact.
std::string everything_about(const RayNode& node);

/// "12 rays to depth 5, 3 branches cut; pixel 0.3 0.25 0.1".
std::string summary(const RayTree& tree);

}  // namespace raylab
