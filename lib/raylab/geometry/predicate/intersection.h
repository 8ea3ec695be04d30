#pragma once

#include "raylab/geometry/predicate/flat_intersection.h"
#include "raylab/geometry/predicate/quadric_intersection.h"
#include "raylab/geometry/predicate/revolution_intersection.h"
#include "raylab/geometry/predicate/triangle_intersection.h"

#include <cassert>
#include <memory>
#include <variant>

namespace raylab {

/// The nearest hit of any shape but a mesh at its place (`motion` null: at rest there), in the number type T: one
/// source of every decision, run with Enclosure first and with Dyadic where signs stay undecided (the scheme of CGAL's
/// Filtered_predicate).
template <Scalar T>
std::optional<Intersection<T>> intersect(const Ray& ray, const Shape& shape, const Affine& placement,
                                         const Motion* motion, Sides sides, Signs<T>& signs) {
    const TransformedRay<T> local =
        motion ? transformed_ray<T>(ray, placement, *motion) : transformed_ray<T>(ray, placement);
    return std::visit(
        [&]<class S>(const S& s) -> std::optional<Intersection<T>> {
            if constexpr (std::same_as<S, std::shared_ptr<const Mesh>>) {
                assert(!"a mesh is hit triangle by triangle");
                return std::nullopt;
            } else {
                return intersect(local, s, sides, signs);
            }
        },
        shape);
}

}  // namespace raylab
