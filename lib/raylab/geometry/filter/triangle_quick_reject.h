#pragma once

#include "raylab/geometry/bounds/ray_in_floats.h"
#include "raylab/number/scalar.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

// A rejection test of a ray and a triangle in floats: most triangles in a cell are missed, and mostly by far.

namespace raylab {

/// A triangle as the quick rejection reads it: along each axis its vertices side by side.
class TriangleRows {
public:
    explicit TriangleRows(const Triangle& t) : at_{t.a.x, t.b.x, t.c.x, t.a.y, t.b.y, t.c.y, t.a.z, t.b.z, t.c.z, 0} {}

    Triangle triangle() const { return {{at_[0], at_[3], at_[6]}, {at_[1], at_[4], at_[7]}, {at_[2], at_[5], at_[8]}}; }
    /// Where an axis's coordinates begin.
    static constexpr std::size_t row(std::size_t axis) { return 3 * axis; }
    /// The fourth float means nothing.
    FourFloats along(std::size_t row) const {
        FourFloats coordinates;
        std::memcpy(&coordinates, at_.data() + row, sizeof coordinates);
        return coordinates;
    }

private:
    std::array<float, 10> at_;  // the tenth, for the last row is read as four floats, too
};

/// A ray prepared to tell triangles that it surely misses.
///
/// Seen from the origin and sheared along the ray's dominant axis (Woop, Benthin and Wald, Watertight Ray/Triangle
/// Intersection, JCGT 2(1), 2013), x = (a_x - o_x) - s (a_z - o_z), a triangle is missed where two of the areas that
/// its edges span with the origin have different signs. With u = 2^-24, x errs by u of its first term, 4 u of its
/// second (s has two roundings) and u of itself: together for both axes by less than e. An area p_x q_y - p_y q_x of
/// coordinates no larger than r then errs by less than 2 r e + 2 e e + 4 u r r, and r is at most R, which the box about
/// all triangles tells: it errs by less than c + r l with c and l of the ray alone. The three vertices, and the three
/// areas, are computed at once.
class TriangleQuickReject {
public:
    /// The triangles lie inside the box.
    TriangleQuickReject(const Ray& ray, const Box& all) {
        const RayInFloats floats(ray, all);
        is_tame_ = floats.fit_floats();
        if (!is_tame_) return;
        const FourFloats steep = floats.steep, reach = floats.reach;
        const std::size_t z = steep[0] > steep[1] ? (steep[0] > steep[2] ? 0 : 2) : (steep[1] > steep[2] ? 1 : 2),
                          x = z == 2 ? 0 : z + 1, y = 3 - z - x;
        row_x_ = TriangleRows::row(x);
        row_y_ = TriangleRows::row(y);
        row_z_ = TriangleRows::row(z);
        const FourFloats shear = floats.direction * all_four(1 / floats.direction[z]);
        shear_x_ = all_four(shear[x]);
        shear_y_ = all_four(shear[y]);
        origin_x_ = all_four(floats.origin[x]);
        origin_y_ = all_four(floats.origin[y]);
        origin_z_ = all_four(floats.origin[z]);

        const float beside = reach[x] + reach[y], ahead = (std::abs(shear[x]) + std::abs(shear[y])) * reach[z];
        const float error = unit * spare * (2 * beside + 5 * ahead) + 0x1p-139f;  // no less where a product underflows
        linear_ = all_four(spare * (2 * error + 4 * unit * (beside + ahead)));
        constant_ = all_four(spare * 2 * error * error + 0x1p-140f);
    }

    /// Whether it can tell anything: floats suffice for the ray and the box.
    bool is_tame() const { return is_tame_; }

    bool surely_misses(const TriangleRows& triangle) const {
        if (!is_tame_) return false;
        const FourFloats z = triangle.along(row_z_) - origin_z_;
        const FourFloats x = triangle.along(row_x_) - origin_x_ - shear_x_ * z;
        const FourFloats y = triangle.along(row_y_) - origin_y_ - shear_y_ * z;
        const FourFloats area = x * next(y) - y * next(x);
        const FourFloats size = larger(magnitude(x), magnitude(y));
        const FourFloats error = constant_ + linear_ * larger(size, next(size));
        return three_signs(area + error) != 0 && three_signs(error - area) != 0;
    }

private:
    static constexpr float unit = unit_roundoff<float>,
                           spare = 1 + 0x1p-10f;  // spare: for the roundings of the bound itself

    static FourFloats next(FourFloats x) {
        return __builtin_shufflevector(x, x, 1, 2, 0, 3);
    }  // of each vertex the next one's

    bool is_tame_;
    std::size_t row_x_, row_y_, row_z_;  // z: the dominant axis. What follows is the same number four times.
    FourFloats origin_x_, origin_y_, origin_z_, shear_x_, shear_y_;
    FourFloats constant_, linear_;
};

}  // namespace raylab
