#pragma once

#include "raylab/number/scalar.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace raylab {

/// Three coordinates of any Scalar. GLM holds the machine numbers (Vec3 below); its vectors refuse the exact ones.
template <Scalar T>
struct Triple {
    T x, y, z;

    friend Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Triple operator*(const T& s, const Triple& a) { return {s * a.x, s * a.y, s * a.z}; }
    friend T dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    friend Triple cross(const Triple& a, const Triple& b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }
};

namespace detail {
template <Scalar T>
struct VectorOf {
    using type = Triple<T>;
};
template <Real T>
struct VectorOf<T> {
    using type = glm::vec<3, T, glm::defaultp>;
};
}  // namespace detail

/// Three coordinates: glm::vec3, glm::dvec3, ... for machine numbers, Triple for exact ones. dot and cross are found
/// by argument for both.
template <Scalar T>
using Vec3 = typename detail::VectorOf<T>::type;

using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

/// The same vector in another number type; exact wherever To holds every From.
template <Scalar To, class From>
Vec3<To> convert(const From& v) {
    return {cast<To>(v.x), cast<To>(v.y), cast<To>(v.z)};
}

}  // namespace raylab
