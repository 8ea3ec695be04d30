#pragma once

#include "raylab/experiment/ray_sphere/ray_sphere.h"
#include "raylab/geometry/affine.h"

#include <array>

// Ways to intersect the unit sphere at a place: the image of |x| = 1 under an affine map, an ellipsoid of any attitude.
// Each is a template on the number type it computes in; t is the same before and after the map, as long as nobody makes
// the direction unit again. Equations: chapter 04.

namespace raylab {

/// The map of a placement, and the three cross products of its columns: the rows of its adjugate.
template <Real T>
struct PlacementOf {
    std::array<Vec3<T>, 3> columns;
    std::array<Vec3<T>, 3> adjugate;
    T determinant;
    Vec3<T> translation;

    explicit PlacementOf(const Affine& placement)
        : columns{convert<T>(placement.columns[0]), convert<T>(placement.columns[1]), convert<T>(placement.columns[2])},
          adjugate{cross(columns[1], columns[2]), cross(columns[2], columns[0]), cross(columns[0], columns[1])},
          determinant(dot(columns[0], adjugate[0])),
          translation(convert<T>(placement.translation)) {}
};

template <Real T>
Vec3<T> times(const std::array<Vec3<T>, 3>& rows, const Vec3<T>& v) {
    return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
}

/// The textbook's way: one 3 x 4 inverse, the translation multiplied into its last column beforehand.
template <Real T>
struct InverseMatrix {
    std::array<Vec3<T>, 3> rows;
    Vec3<T> last_column;

    explicit InverseMatrix(const Affine& map) {
        const PlacementOf<T> placement(map);
        for (std::size_t i = 0; i < 3; ++i) rows[i] = placement.adjugate[i] / placement.determinant;
        last_column = -times<T>(rows, placement.translation);
    }

    std::optional<T> hit(const RayOf<T>& ray) const {
        return stable_sphere_hit<T>(
            {times<T>(rows, ray.origin) + last_column, times<T>(rows, ray.direction), ray.range}, {{0, 0, 0}, 1});
    }
};

/// The same, but the origin is moved before it is multiplied: two near points are subtracted while they are still
/// exact.
template <Real T>
struct InverseAfterMove {
    std::array<Vec3<T>, 3> rows;
    Vec3<T> translation;

    explicit InverseAfterMove(const Affine& map) : translation(convert<T>(map.translation)) {
        const PlacementOf<T> placement(map);
        for (std::size_t i = 0; i < 3; ++i) rows[i] = placement.adjugate[i] / placement.determinant;
    }

    std::optional<T> hit(const RayOf<T>& ray) const {
        return stable_sphere_hit<T>(
            {times<T>(rows, ray.origin - translation), times<T>(rows, ray.direction), ray.range}, {{0, 0, 0}, 1});
    }
};

/// Nothing is divided: the ray is carried by the adjugate, and the sphere grows by the determinant instead.
template <Real T>
struct Adjugate {
    std::array<Vec3<T>, 3> rows;
    Vec3<T> translation;
    T radius;

    explicit Adjugate(const Affine& map) : translation(convert<T>(map.translation)) {
        const PlacementOf<T> placement(map);
        rows = placement.adjugate;
        radius = std::abs(placement.determinant);
    }

    std::optional<T> hit(const RayOf<T>& ray) const {
        return stable_sphere_hit<T>(
            {times<T>(rows, ray.origin - translation), times<T>(rows, ray.direction), ray.range}, {{0, 0, 0}, radius});
    }
};

/// The other way round: the ray stays, the sphere's equation is carried to the world, where it is x^T A x = 1 about the
/// translation, A being the inverse's transpose times the inverse.
template <Real T>
struct WorldQuadric {
    std::array<Vec3<T>, 3> a;  // rows of A
    Vec3<T> translation;

    explicit WorldQuadric(const Affine& map) : translation(convert<T>(map.translation)) {
        const InverseAfterMove<T> inverse(map);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                a[static_cast<std::size_t>(i)][j] = inverse.rows[0][i] * inverse.rows[0][j] +
                                                    inverse.rows[1][i] * inverse.rows[1][j] +
                                                    inverse.rows[2][i] * inverse.rows[2][j];
    }

    std::optional<T> hit(const RayOf<T>& ray) const {
        const Vec3<T> from = ray.origin - translation;
        const Vec3<T> carried = times<T>(a, ray.direction);
        const Quadratic<T> quadratic{dot(ray.direction, carried), dot(from, carried), dot(from, times<T>(a, from)) - 1};
        return first_inside(ray.range, stable_roots(quadratic, quadratic.discriminant()));
    }
};

/// The usual mistake: the carried direction is made unit, and t is then a length in object space.
template <Real T>
struct UnitAgain {
    InverseAfterMove<T> inverse;

    explicit UnitAgain(const Affine& map) : inverse(map) {}

    std::optional<T> hit(const RayOf<T>& ray) const {
        const Vec3<T> origin = times<T>(inverse.rows, ray.origin - inverse.translation);
        const Vec3<T> direction = glm::normalize(times<T>(inverse.rows, ray.direction));
        return stable_sphere_hit<T>({origin, direction, ray.range}, {{0, 0, 0}, 1});
    }
};

}  // namespace raylab
