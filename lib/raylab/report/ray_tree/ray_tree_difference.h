#pragma once

#include "raylab/tracer/whitted/ray_tree.h"

// The first difference between two ray trees: a student's and the reference's, or of two ways to start rays.

namespace raylab {

/// How far numbers may be apart and count as the same. Trees computed in floats and in doubles agree to about 1e-6.
struct RayTreeTolerance {
    double absolute = 1e-6;
    double relative = 1e-5;
};

/// One field in which a node differs, in words.
struct DifferingField {
    std::string name;  // "kind", "depth", "direction", "object", "ended", "t", "point", "normal", "throughput", "local
                       // colour", "contribution"
    std::string got, expected;
};

/// The first node that differs.
struct RayTreeDifference {
    enum class In { both, got, expected } in = In::both;  // which of the trees have such a node
    std::size_t got = 0, expected = 0;   // its index in either tree; where there is none, that of its parent
    std::vector<DifferingField> fields;  // in the order in which they are compared; at least one
    std::string place;  // "the eye ray", "the eye ray's reflected ray", "the reflected ray below eye, transmitted"
};

/// Parents come before children, the nearest to the eye first; children are matched by kind (shadow rays by light, too)
/// and, among equals, by order. A branch that one of the trees lacks comes before its siblings' fields. The fields are
/// compared in the order kind, depth, direction, object, ended, t, point, normal, throughput, local colour,
/// contribution; of siblings the one that differs in the earlier field comes first. At last the pixel is compared.
/// Absent: the trees are the same.
std::optional<RayTreeDifference> first_difference(const RayTree& got, const RayTree& expected,
                                                  const RayTreeTolerance& tolerance = {});

/// "the first node that differs is the eye ray's reflected ray: local colour expected 0.1 0.2 0.3, got 0.2 0.4 0.6".
std::string to_string(const RayTreeDifference& difference);

}  // namespace raylab
