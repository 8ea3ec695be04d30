#include "bystander.h"

#include "raylab/image/color.h"
#include "raylab/scene/picture_point.h"
#include "raylab/tracer/picture/first_hit_picture.h"

namespace raylab::ray_generation {

namespace {

constexpr double darker = -1.3;  // in stops

Image dark_scene(const Stage& stage, const CameraFrame& frame) {
    return exposed(first_hit_picture(stage.scene, stage.accelerator, frame, FirstHitShading::light,
                                     {.samples = {.per_side = 3}, .threads = stage.threads}),
                   darker);
}

}  // namespace

Bystander::Bystander(const Stage& stage, const Vec3d& position, const Vec3d& target, ImageSize size)
    : frame_(camera_frame({.position = position, .target = target, .projection = Perspective{36}}, size)),
      scale_(size.width / 640.0),
      picture_(dark_scene(stage, frame_)) {}

void Bystander::line(const Vec3d& from, const Vec3d& to, double width, const Pixel& color) {
    const auto a = picture_point(frame_, from), b = picture_point(frame_, to);
    if (a && b) draw_line(picture_, *a, *b, scale_ * width, color);
}

void Bystander::arrow(const Vec3d& from, const Vec3d& to, double width, const Pixel& color) {
    const auto a = picture_point(frame_, from), b = picture_point(frame_, to);
    if (a && b) draw_arrow(picture_, *a, *b, scale_ * width, color);
}

void Bystander::dot(const Vec3d& at, double radius, const Pixel& color) {
    const auto p = picture_point(frame_, at);
    if (!p) return;
    draw_disk(picture_, *p, scale_ * (radius + 1), ink::black);
    draw_disk(picture_, *p, scale_ * radius, color);
}

void Bystander::label(const Vec3d& at, const std::string& text, Point2 beside, const Pixel& color) {
    const auto p = picture_point(frame_, at);
    if (!p) return;
    const double height = 10 * scale_;
    const Point2 start{p->x + scale_ * beside.x, p->y + scale_ * beside.y};
    const double middle = start.y - height / 2, end = start.x + text_width(text, height) - 3 * scale_;
    draw_line(picture_, *p, {start.x, middle}, 0.8 * scale_, ink::white);
    draw_line(picture_, {start.x, middle}, {end, middle}, 1.9 * height, ink::white);
    draw_text(picture_, start, height, text, color);
}

}  // namespace raylab::ray_generation
