#pragma once

#include "raylab/geometry/meet_flat.h"
#include "raylab/geometry/meet_quadric.h"
#include "raylab/geometry/meet_revolution.h"
#include "raylab/geometry/meet_triangle.h"

#include <cassert>
#include <memory>
#include <variant>

namespace raylab {

/// The nearest hit of any shape but a mesh at its place, in the number type T: one source of every decision, run with
/// Enclosure first and with Dyadic where signs stay undecided (the scheme of CGAL's Filtered_predicate).
template <Scalar T>
std::optional<Meeting<T>> meet(const Ray& ray, const Shape& shape, const Affine& placement, Sides sides, Signs<T>& signs) {
    const LocalRay<T> local = local_ray<T>(ray, placement);
    return std::visit(
        [&]<class S>(const S& s) -> std::optional<Meeting<T>> {
            if constexpr (std::same_as<S, std::shared_ptr<const Mesh>>) {
                assert(!"a mesh is met triangle by triangle");
                return std::nullopt;
            } else {
                return meet(local, s, sides, signs);
            }
        },
        shape);
}

}  // namespace raylab
