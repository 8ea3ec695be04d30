#pragma once

#include "drawings.h"

#include "raylab/image/draw.h"

#include <string>

namespace raylab::ray_generation {

/// The scene as seen by a bystander, darkened, so that lines drawn over it stand out. Widths and sizes are in pixels of
/// a picture 640 wide.
class Bystander {
public:
    Bystander(const Stage& stage, const Vec3d& position, const Vec3d& target, ImageSize size);

    void line(const Vec3d& from, const Vec3d& to, double width, const Pixel& color);
    void arrow(const Vec3d& from, const Vec3d& to, double width, const Pixel& color);
    void dot(const Vec3d& at, double radius, const Pixel& color);

    /// Writes words on a light plate that is `beside` (in pixels) the point and connected to it by a thin line.
    void label(const Vec3d& at, const std::string& text, Point2 beside, const Pixel& color = ink::black);

    const Image& picture() const { return picture_; }

private:
    CameraFrame frame_;
    double scale_;  // pixels of this picture to one of a picture 640 wide
    Image picture_;
};

}  // namespace raylab::ray_generation
