#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/whitted/whitted.h"

#include <memory>

// Rooms of mirrors and glass whose colours are known in closed form.

namespace raylab::recursion {

/// A scene with its accelerator and the eye.
struct Room {
    std::unique_ptr<const Scene> scene;
    std::unique_ptr<Accelerator> accelerator;
    Ray eye;

    RayTree tree(const WhittedOptions& options) const { return ray_tree(*scene, *accelerator, options, eye); }
    double brightness(const WhittedOptions& options) const { return tree(options).pixel.x; }
};

/// Two parallel mirrors face each other; each reflects `reflects` and emits 1. The eye between them looks
/// perpendicularly at one.
Room hall_of_mirrors(double reflects);
double hall_of_mirrors_truth(double reflects);             // sum of reflects^k
double hall_of_mirrors_truth(double reflects, int depth);  // ... of the first `depth` terms

/// Panes of glass (1.5) one behind the other in front of a background of 1; the eye looks perpendicularly at them, and
/// its side is dark.
Room panes(int count);
double panes_truth(int count);  // (1 - r) / (1 + (2 count - 1) r), r = .04

/// Concentric spheres of glass and air in turn, `surfaces` of them (an odd number: the outermost is glass), about an
/// eye in the innermost glass. Each emits a little, and every ray splits at every hit, so a ray leaves only through all
/// of them.
Room glass_chamber(int surfaces);

/// The most that a ray of the chamber which may go on for `depth` hits can return.
double glass_chamber_brightest(int depth);

}  // namespace raylab::recursion
