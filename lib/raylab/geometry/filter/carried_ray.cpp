#include "raylab/geometry/filter/carried_ray.h"

#include "raylab/number/enclosure.h"
#include "raylab/number/scalar.h"

#include <cmath>

namespace raylab {

// The rows as computed are wrong by what enclosures say of them. What they make of a vector v, itself rounded, is off
// by three roundings of each product and one of v: together by less than (error + 8 u size) |v|, with the Frobenius
// norms of error and rows. Looking from a point adds one rounding of what is left. A quarter of `off` is to spare for
// that, and for the roundings of this bound itself.
CarryBack::CarryBack(const Affine& placement) : translation_(convert<double>(placement.translation)) {
    const auto& columns = placement.columns;
    const auto x = convert<Enclosure>(columns[0]), y = convert<Enclosure>(columns[1]),
               z = convert<Enclosure>(columns[2]);
    const std::array<Vec3<Enclosure>, 3> adjugate{cross(y, z), cross(z, x), cross(x, y)};
    const Enclosure determinant = dot(x, adjugate[0]);
    double squared_size = 0, squared_error = 0;
    for (std::size_t row = 0; row < 3; ++row) {
        const Vec3<Enclosure>& of = adjugate[row];
        const std::array entries{of.x / determinant, of.y / determinant, of.z / determinant};
        for (std::size_t i = 0; i < 3; ++i) {
            rows_[row][static_cast<int>(i)] = entries[i].middle();
            squared_size += entries[i].middle() * entries[i].middle();
            squared_error += entries[i].radius() * entries[i].radius();
        }
    }
    const double loss = std::sqrt(squared_error) + 8 * unit_roundoff<double> * std::sqrt(squared_size);
    squared_loss_ = loss * loss / (CarriedRay::off * CarriedRay::off * 9 / 16);
}

std::optional<CarriedRay> CarryBack::operator()(const Ray& ray, const Vec3d& from) const {
    const auto carried = [&](const Vec3d& v) { return Vec3d(dot(rows_[0], v), dot(rows_[1], v), dot(rows_[2], v)); };
    const Vec3d way = convert<double>(ray.origin) - translation_, direction = convert<double>(ray.direction);
    const CarriedRay result{carried(way) - from, carried(direction), ray.range};
    const bool is_known = squared_loss_ * dot(way, way) <= dot(result.origin, result.origin) &&
                          squared_loss_ * dot(direction, direction) <= dot(result.direction, result.direction);
    return is_known ? std::optional(result) : std::nullopt;
}

}  // namespace raylab
