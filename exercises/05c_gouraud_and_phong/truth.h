#pragma once

#include "arguments.h"

// The truth, mixed in long double; and the same with something else in a place, by which a mistake is known.

namespace raylab::grading::mesh_hit {

/// What both interpolations are made of: the vertices' weights, and normals that are turned to one side or not.
struct Ingredients {
    std::array<double, 3> weights;
    std::array<Vec3d, 3> normals;
    Vec3d face;
};

inline std::array<double, 3> weights_of(const InterpolatedHit& hit) { return {1 - hit.u - hit.v, hit.u, hit.v}; }

/// Whether the triangle is seen from its front, 1, or from behind, -1.
inline double side_of(const InterpolatedHit& hit) { return dot(hit.face, hit.to_viewer) < 0 ? -1 : 1; }

inline Ingredients turned(const InterpolatedHit& hit, double side) {
    Ingredients made{weights_of(hit), hit.normals, side * hit.face};
    for (Vec3d& normal : made.normals) normal *= side;
    return made;
}

inline Ingredients ingredients(const InterpolatedHit& hit) { return turned(hit, side_of(hit)); }

inline Vec3<long double> mixed_in_full(const Ingredients& made) {
    Vec3<long double> sum(0);
    for (std::size_t i = 0; i < 3; ++i)
        sum += static_cast<long double>(made.weights[i]) * convert<long double>(made.normals[i]);
    return sum;
}
inline Vec3d mixed(const Ingredients& made) { return convert<double>(mixed_in_full(made)); }

inline bool cancels(const InterpolatedHit& hit) { return mixed(ingredients(hit)) == Vec3d{0, 0, 0}; }

inline InterpolatedBrightness shaded(const Model& model, const Ingredients& made) {
    long double gouraud = 0;
    for (std::size_t i = 0; i < 3; ++i)
        gouraud += static_cast<long double>(made.weights[i]) * static_cast<long double>(model(made.normals[i]));
    const auto sum = mixed_in_full(made);
    const bool is_zero = sum == Vec3<long double>(0);
    return {static_cast<double>(gouraud), model(is_zero ? made.face : convert<double>(glm::normalize(sum)))};
}

inline InterpolatedBrightness truth(const Arguments& given) { return shaded(given.model, ingredients(given.hit)); }

}  // namespace raylab::grading::mesh_hit
