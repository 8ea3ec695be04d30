#pragma once

#include "raylab/scene/camera.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace raylab {

/// The sum of the coordinates' sizes.
inline double sum_of_sizes(const Vec3d& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// A camera's picture, as points of space and eye rays fall into it, and what rounding may do about that. A ray is
/// asked where it goes, not where it was meant to go: that its floats are no longer those of a pixel's middle does not
/// matter.
///
/// Both are multiplied by the same three axes: x / w is the column, y / w the row, in pixels from the top left corner.
/// So for a point on a ray the exact quotients are equal, whatever rounding made of the axes.
class PictureView {
public:
    explicit PictureView(const CameraFrame& frame);

    /// Pixels are numbered row by row.
    std::size_t number(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width) +
               static_cast<std::size_t>(column);
    }
    /// The pixel an eye ray of this camera goes through; absent: another ray, or one that passes beside the picture.
    std::optional<std::size_t> pixel(const Ray& ray) const;

    struct Image {
        double x, y, w;  // w is 1 in an orthographic picture
        double depth;    // along the view, metres
    };
    Image image(const Vec3d& point) const;

    /// The distance, in pixels, by which rounding may move the column or row of a point's image and the ray's through
    /// it apart, where w is at least this. `size` bounds the sum of the coordinates' sizes, `off` how far the point is
    /// known to lie from where it is said to lie.
    double error(double size, double off, double w) const;

    /// The error bound of w and depth.
    double depth_error(double size, double off) const { return rounding * (size + eye_size_) + 2 * off; }

    /// A lower bound of w, exactly, of what is seen at this distance from the eye or beyond.
    double min_w(double distance) const { return perspective() ? distance / steepest_ * below : 1; }

    bool perspective() const { return projection_ == CameraFrame::Projection::perspective; }
    const Vec3d& eye() const { return eye_; }
    const Vec3d& forward() const { return forward_; }
    double behind() const { return behind_; }  // rays begin at most so far behind or before depth 0
    ImageSize size() const { return image_; }

    /// The factor that makes a length surely no more than it was: directions are rounded to floats, and so not quite
    /// of length 1.
    static constexpr double below = 1 - 0x1p-18;

private:
    // A coordinate is made of a dozen rounded operations on numbers whose sizes sum up to `size`, and so is its part in
    // a crossing with an edge or a row; each costs half a unit.
    static constexpr double rounding = 64 * unit_roundoff<double>;

    // A ray's w is at least 1 / steepest_ and errs by 2^-47: up to here it is known to 2^-17 of itself. In a wider
    // picture rays are not told apart from those along the picture plane.
    static constexpr double steepest_known = 0x1p30;

    bool is_of_this_camera(const Ray& ray) const;

    CameraFrame::Projection projection_;
    ImageSize image_;
    Vec3d eye_, forward_;
    double eye_size_;
    Vec3f start_, direction_;  // of every ray, in a perspective and an orthographic picture
    Vec3d column_, row_;       // axes
    Vec3d middle_{0, 0, 0};    // what is added to x and y
    double longest_ = 0;       // of the axes' coordinates
    double steepest_ = 1;      // the largest distance / w in the picture
    double behind_ = 0;
};

[[gnu::always_inline]] inline bool PictureView::is_of_this_camera(const Ray& ray) const {
    if (!(ray.range.min >= 0) || !(steepest_ <= steepest_known)) return false;
    if (perspective()) {
        if (ray.origin != start_) return false;
        const Vec3d d = convert<double>(ray.direction);
        return std::abs(dot(d, d) - 1) <= 0x1p-20;
    }
    return ray.direction == direction_ && std::abs(dot(convert<double>(ray.origin) - eye_, forward_)) <= behind_;
}

// (Inlined, because every eye ray is asked, and an optional that is not returned costs nothing.)
[[gnu::always_inline]] inline std::optional<std::size_t> PictureView::pixel(const Ray& ray) const {
    if (!is_of_this_camera(ray)) return std::nullopt;
    const Vec3d v = perspective() ? convert<double>(ray.direction) : convert<double>(ray.origin) - eye_;
    const double w = perspective() ? dot(v, forward_) : 1;
    if (!(w > 0)) return std::nullopt;
    const double column = (dot(v, column_) + middle_.x) / w, row = (dot(v, row_) + middle_.y) / w;
    if (!(column >= 0 && column < image_.width && row >= 0 && row < image_.height)) return std::nullopt;
    return number(static_cast<int>(column), static_cast<int>(row));
}

}  // namespace raylab
