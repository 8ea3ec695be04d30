#pragma once

#include "raylab/tracer/shading/surface_point.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

enum class RayKind { eye, reflected, transmitted, shadow, diffuse };

/// Why a branch of the ray tree goes no further.
enum class Ending {
    branched,                   // it does: there are children
    diffuse,                    // the surface neither reflects nor transmits
    depth,                      // the tree may not be deeper
    threshold,                  // it could not add enough to the pixel
    roulette,                   // chance ended a path that carried little
    missed,                     // no surface in this direction: the background
    total_internal_reflection,  // nothing is transmitted at this angle
    reached,                    // a shadow ray that found its light
    blocked,                    // a shadow ray that did not
};

/// One ray and what it hit.
struct RayNode {
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    RayKind kind = RayKind::eye;
    Ending ended = Ending::branched;
    std::size_t parent = none;  // its index among the nodes
    std::size_t light = none;   // of a shadow ray
    int depth = 1;              // the eye ray's is 1
    double throughput = 1;      // the product of the coefficients on the way here: its largest share of the pixel
    double density = 0;         // per steradian, with which its direction was chosen; 0: there was no choice
    std::size_t samples = 1;    // of a tree that was folded (report/ray_tree/folded_tree.h): those with such a ray
    Ray ray = {};               // a branch that was not followed has none: see `ended`
    std::string object = {};    // path of what was hit, a shadow ray's obstacle not; empty: nothing
    double t = std::numeric_limits<double>::infinity();
    Vec3d point{0, 0, 0}, normal{0, 0, 0};
    Color local{0, 0, 0};  // the colour made here: a surface's by lights, the background's
    Color contribution{0, 0,
                       0};  // throughput * local: what it adds to the pixel. A shadow ray's is part of its parent's
};

/// All rays spawned by one eye ray, parents before children.
struct RayTree {
    std::vector<RayNode> nodes;
    Color pixel{0, 0, 0};  // the sum of all contributions but the shadow rays'
};

/// Whether there is a ray: a branch that was cut (depth, threshold, total internal reflection) is a node without one.
bool was_cast(const RayNode& node);

/// The same as `parent`, the other way round: the indices of every node's children, in their order.
std::vector<std::vector<std::size_t>> children(const RayTree& tree);

std::string to_string(RayKind kind);   // "eye", "reflected", ...
std::string to_string(Ending ending);  // "branched", "diffuse", "total internal reflection", ...

/// The way back; absent: no such word.
std::optional<RayKind> ray_kind(const std::string& word);
std::optional<Ending> ending(const std::string& word);

}  // namespace raylab
