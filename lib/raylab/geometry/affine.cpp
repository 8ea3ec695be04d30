#include "raylab/geometry/affine.h"

#include "raylab/base/error.h"

#include <gmpxx.h>
#include <glm/common.hpp>

#include <cmath>
#include <numbers>

namespace raylab {

namespace {

Vec3d times(const std::array<Vec3d, 3>& columns, const Vec3d& v) {
    return columns[0] * v.x + columns[1] * v.y + columns[2] * v.z;
}

// True if rounding alone cannot have made the determinant. Products of two floats are exact in double; what follows
// (one subtraction, one product, two sums) errs by less than 8 units of roundoff of the sum of all products'
// magnitudes.
bool surely_regular(const std::array<Vec3f, 3>& columns) {
    const auto a = convert<double>(columns[0]);
    const auto b = convert<double>(columns[1]);
    const auto c = convert<double>(columns[2]);
    const Vec3d positive{b.y * c.z, b.z * c.x, b.x * c.y};
    const Vec3d negative{b.z * c.y, b.x * c.z, b.y * c.x};
    const double magnitude = dot(glm::abs(a), glm::abs(positive) + glm::abs(negative));
    return std::abs(dot(a, positive - negative)) > 8 * unit_roundoff<double> * magnitude;
}

}  // namespace

AffineSteps AffineSteps::translate(Vec3d by) {
    AffineSteps result;
    result.translation = by;
    return result;
}

AffineSteps AffineSteps::scale(Vec3d by) {
    AffineSteps result;
    result.columns = {Vec3d{by.x, 0, 0}, Vec3d{0, by.y, 0}, Vec3d{0, 0, by.z}};
    return result;
}

AffineSteps AffineSteps::rotate(Vec3d axis, double degrees) {
    const double length = glm::length(axis);
    if (!(length > 0)) throw Error("expected a rotation axis that is not zero, found a zero one");
    const Vec3d k = axis / length;
    const double radians = degrees * std::numbers::pi / 180;
    const double cosine = std::cos(radians);
    const double sine = std::sin(radians);
    // Rodrigues: v cos + (k x v) sin + k (k.v)(1 - cos)
    const auto turned = [&](Vec3d v) { return v * cosine + cross(k, v) * sine + k * (dot(k, v) * (1 - cosine)); };
    AffineSteps result;
    result.columns = {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
    return result;
}

AffineSteps AffineSteps::then(const AffineSteps& next) const {
    AffineSteps result;
    for (std::size_t i = 0; i < 3; ++i) result.columns[i] = times(next.columns, columns[i]);
    result.translation = times(next.columns, translation) + next.translation;
    return result;
}

Affine AffineSteps::rounded() const {
    return {{convert<float>(columns[0]), convert<float>(columns[1]), convert<float>(columns[2])},
            convert<float>(translation)};
}

AffineSteps AffineSteps::of(const Affine& affine) {
    const auto& c = affine.columns;
    return {{convert<double>(c[0]), convert<double>(c[1]), convert<double>(c[2])}, convert<double>(affine.translation)};
}

bool is_singular(const Affine& affine) {
    const auto& c = affine.columns;
    if (surely_regular(c)) return false;
    const auto exact = [](const Vec3f& v) { return Triple<mpq_class>{v.x, v.y, v.z}; };
    return sgn(dot(exact(c[0]), cross(exact(c[1]), exact(c[2])))) == 0;
}

Vec3d transform_point(const Affine& affine, const Vec3d& point) {
    return transform_vector(affine, point) + convert<double>(affine.translation);
}

Vec3d transform_vector(const Affine& affine, const Vec3d& vector) {
    return times(AffineSteps::of(affine).columns, vector);
}

}  // namespace raylab
