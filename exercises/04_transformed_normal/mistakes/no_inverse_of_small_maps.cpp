// hint: small_is_not_singular
// Rows of the inverse, but a map with a small determinant is said to have none, and leaves the normal as it is.
#include "raylab/geometry/transformed_normal.h"

#include <cmath>
#include <optional>

raylab::Vec3d raylab::transformed_normal(const std::array<Vec3d, 3>& columns, const Vec3d& normal) {
    using Rows = std::array<Vec3d, 3>;
    const auto inverse = [](const Rows& m) -> std::optional<Rows> {
        const double volume = dot(m[2], cross(m[0], m[1]));
        if (std::abs(volume) <= 1e-8) return std::nullopt;
        return Rows{cross(m[1], m[2]) / volume, cross(m[2], m[0]) / volume, cross(m[0], m[1]) / volume};
    };
    Vec3d carried(0);
    if (const auto rows = inverse(columns))
        for (std::size_t i = 0; i < 3; ++i) carried += (*rows)[i] * normal[static_cast<int>(i)];
    else
        carried = normal;
    return carried / std::sqrt(dot(carried, carried));
}
