#include "raylab/accelerator/item_buffer/picture_view.h"

#include "raylab/geometry/largest_coordinate.h"

#include <algorithm>
#include <cmath>

namespace raylab {

PictureView::PictureView(const CameraFrame& frame)
    : projection_(frame.projection),
      image_(frame.image),
      eye_(convert<double>(convert<float>(frame.eye))),
      forward_(frame.forward),
      eye_size_(sum_of_sizes(eye_)),
      start_(convert<float>(frame.eye)),
      direction_(convert<float>(frame.forward)) {
    const double columns = 0.5 * image_.width, rows = 0.5 * image_.height;
    const Vec3d right = frame.right / frame.half_width, up = frame.up / frame.half_height;
    if (perspective()) {
        column_ = (frame.forward + right) * columns;
        row_ = (frame.forward - up) * rows;
        steepest_ = std::sqrt(1 + frame.half_width * frame.half_width + frame.half_height * frame.half_height);
    } else {
        // The rounded direction leans a little against the axes: what they see of it is taken off again.
        const Vec3d leaning = convert<double>(direction_) / dot(convert<double>(direction_), forward_);
        column_ = (right - forward_ * dot(leaning, right)) * columns;
        row_ = (forward_ * dot(leaning, up) - up) * rows;
        middle_ = {columns, rows, 0};
        behind_ = 0x1p-22 * (sum_of_sizes(frame.eye) + 2 * (frame.half_width + frame.half_height));
    }
    longest_ =
        std::max({largest_coordinate(column_), largest_coordinate(row_), 0.5 * image_.width, 0.5 * image_.height});
}

PictureView::Image PictureView::image(const Vec3d& point) const {
    const Vec3d v = point - eye_;
    const double depth = dot(v, forward_);
    return {dot(v, column_) + middle_.x, dot(v, row_) + middle_.y, perspective() ? depth : 1, depth};
}

double PictureView::error(double size, double off, double w) const {
    // A quotient x / w is off by what x is off and |x / w| times what w is off, over w: x's axis and the picture are at
    // most twice `longest_`, so this is 256 units of the largest x / w; and three times as much for what is made of it.
    const double of_point = 16 * longest_ * depth_error(size, off) / w;
    // The ray's own: its direction is of length 1 and its w at least 1 / steepest_; or it starts within the picture.
    const double of_ray = 4 * longest_ * rounding * (perspective() ? 4 * steepest_ : behind_ * 0x1p22);
    return of_point + of_ray + rounding * (image_.width + image_.height);
}

}  // namespace raylab
