#pragma once

#include "raylab/experiment/adversarial/adversarial.h"
#include "raylab/geometry/bounds/box.h"
#include "raylab/scene/scene.h"

#include <string>
#include <vector>

namespace raylab::adversarial {

/// Rays that are hard for the structures over a scene: each kind aims at a case in which tests of boxes and cells are
/// close to their decision boundary.
class SceneRays {
public:
    /// Where something moves, they are aimed at where it stands at this time; half of them have it, and the others any.
    explicit SceneRays(const Scene& scene, float time = 0);

    /// "random", "axis-aligned", "in a plane", "at a vertex", "at an edge", "grazing", "outside", "behind", "on a box",
    /// ...
    static const std::vector<std::string>& kinds();

    /// A ray of one kind; its range begins at 0. Origin and direction are finite, and the direction is not zero.
    Ray draw(Draw& draw, std::size_t kind) const;

private:
    Vec3f vertex(Draw& draw) const;
    Vec3f beside_an_edge(Draw& draw) const;
    Vec3f on_a_box(Draw& draw) const;
    Vec3f somewhere(Draw& draw, double reach) const;
    Ray at_its_own_scale(Draw& draw) const;
    Ray of_kind(Draw& draw, std::size_t kind) const;

    float time_;
    bool moves_;
    Interval<float> times_;
    Box bounds_;                       // of the whole scene, finite
    std::vector<Triangle> triangles_;  // of meshes, transformed; for other shapes three points of the shape's box
    std::vector<Box> boxes_;           // of the primitives
};

}  // namespace raylab::adversarial
