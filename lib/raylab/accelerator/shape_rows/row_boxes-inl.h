// Compiled once for every instruction set (see row_questions.cpp): a guard that opens again for the next.
#if defined(RAYLAB_ROW_BOXES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_ROW_BOXES_INL_H
#undef RAYLAB_ROW_BOXES_INL_H
#else
#define RAYLAB_ROW_BOXES_INL_H
#endif

#include "raylab/accelerator/shape_rows/row_ray-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

// A ray that begins at t >= 0 and boxes, by their slabs, in doubles: one that it exactly hits is never missed.
//
// Along an axis where the direction is zero, its inverse stands for infinity as 2^600. Boxes are grown by at least
// 2^-300 (shape_rows.cpp), so that no origin, a float, lies in a plane, and the t of a plane there is at least 2^300.
// Along any other axis t is at most 2^129 / 2^-149 = 2^278: a zero component decides inside or outside and nothing
// else, nothing is multiplied to zero or NaN, and nothing over- or underflows. What is left are three roundings of each
// t, 2^-51.4 of it: the entry is made smaller by 2^-50 of it, the exit larger.
class RowBoxes {
public:
    HWY_INLINE RowBoxes(const ShapeRows& rows, const RowRay& row_ray, const Ray& ray, double end)
        : rows_(rows),
          ray_(row_ray),
          x_(number(inverse(ray.direction.x))),
          y_(number(inverse(ray.direction.y))),
          z_(number(inverse(ray.direction.z))),
          start_(number(ray.range.min)),
          end_(number(end)) {}

    // Which boxes are hit, from place i on; and where they are entered. (Which of two planes is met first their t tell:
    // to choose them by the direction's sign is a branch, and often mispredicted.)
    HWY_INLINE Bools hit_mask(std::size_t i, double* entries) const {
        Doubles entry = start_, exit = end_;
        const auto cut = [&](std::size_t axis, Doubles origin, Doubles inverse) HWY_ATTR {
            const Doubles lower = hn::Mul(hn::Sub(load(rows_.lower[axis], i), origin), inverse),
                          upper = hn::Mul(hn::Sub(load(rows_.upper[axis], i), origin), inverse);
            entry = hn::Max(entry, hn::Min(lower, upper));
            exit = hn::Min(exit, hn::Max(lower, upper));
        };
        cut(0, ray_.ox, x_);
        cut(1, ray_.oy, y_);
        cut(2, ray_.oz, z_);
        entry = hn::Mul(entry, number(1 - 0x1p-50));
        hn::StoreU(entry, doubles_tag, entries + i);
        return hn::Le(entry, hn::Mul(exit, number(1 + 0x1p-50)));
    }

private:
    static HWY_INLINE double inverse(double x) { return x == 0 ? 0x1p600 : 1 / x; }

    const ShapeRows& rows_;
    const RowRay& ray_;
    const Doubles x_, y_, z_, start_, end_;
};

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
