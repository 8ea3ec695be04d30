#pragma once

#include "raylab/accelerator/item_buffer/picture_hull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace raylab {

/// The pixels of one row that a primitive may be seen through.
struct PictureRow {
    int row, first, last;
};

/// A hull as it lies in the picture, and which of its pixels' rays may hit what is in it: of all closed pixels that the
/// hull overlaps, none is missing, and the few too many are those that it comes as near to as rounding may be.
///
/// The part behind the eye is cut off first, at a w that nothing seen is below: no divisor w is zero, or near it.
class PictureRows {
public:
    PictureRows(const PictureView& view, const PictureHull& hull);

    /// The smallest t at which any eye ray may hit the primitive.
    double begins() const { return begins_; }

    /// Whether the picture is too near, or its numbers are too large, to say where in it the hull is.
    bool everywhere() const { return everywhere_; }

    /// Calls at(PictureRow) for every row with pixels; none, where the hull is everywhere.
    template <class At>
    void for_each(const At& at) const;

private:
    struct Point {
        double x, y;
    };
    struct Columns {
        double left = std::numeric_limits<double>::infinity(), right = -left;

        void unite(double x) {
            left = std::min(left, x);
            right = std::max(right, x);
        }
    };
    using Images = std::array<PictureView::Image, 8>;

    void find_depth(const PictureView& view, const PictureHull& hull, const Images& images);
    void cut(const PictureHull& hull, const Images& images, double w);
    void find_extent(const PictureView& view);
    bool is_small() const;
    void keep_outline();
    Columns between(double top, double bottom) const;

    // Of the corners four may be before the cut, four behind it; an outline may have each on both of its sides.
    static constexpr std::size_t largest = 2 * (8 + 16);
    using Points = std::array<Point, largest>;

    Points points_;  // of more than a few pixels: the corners of their outline, in order
    std::size_t count_ = 0;
    bool everywhere_ = false, behind_ = false;
    double begins_ = 0, error_ = 0;
    int top_ = 0, bottom_ = -1;
    Columns widest_;
    ImageSize image_;
};

template <class At>
void PictureRows::for_each(const At& at) const {
    const double last_column = image_.width - 1;
    const bool small = is_small();
    for (int row = top_; row <= bottom_; ++row) {
        const Columns columns = small ? widest_ : between(row - error_, row + 1 + error_);  // little is to be gained
        const double first = std::max(std::floor(columns.left - error_), 0.0);
        const double last = std::min(std::floor(columns.right + error_), last_column);
        if (first <= last) at(PictureRow{row, static_cast<int>(first), static_cast<int>(last)});
    }
}

}  // namespace raylab
