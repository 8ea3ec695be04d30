#include "incoming_light.h"

#include "raylab/accelerator/accelerator.h"
#include "raylab/base/tiles.h"
#include "raylab/image/draw.h"
#include "raylab/image/to_pixel.h"
#include "raylab/tracer/shading/illumination.h"
#include "raylab/tracer/whitted/whitted.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace raylab::lighting {

namespace {

constexpr Vec3d floor_point{-0.6, 1e-6, 1.25};  // on the floor, between the balls
constexpr int side = 600;
constexpr double quarter_turn = std::numbers::pi / 2;

// The distance from the middle is the angle to the vertical: 1 is the horizon. The camera's side is below.
Vec3d direction_at(double x, double y) {
    const double radius = std::hypot(x, y), angle = radius * quarter_turn;
    const double across = radius > 0 ? std::sin(angle) / radius : 0;
    return {x * across, std::cos(angle), y * across};
}

Point2 place_of(const Vec3d& direction) {
    const double across = std::hypot(direction.x, direction.z), radius = std::acos(direction.y) / quarter_turn;
    const double scale = across > 0 ? radius / across : 0;
    return {side / 2.0 * (1 + direction.x * scale), side / 2.0 * (1 + direction.z * scale)};
}

Image hemisphere(const ChapterRun& run, const std::function<Color(const Vec3d&)>& color) {
    const int per_side = run.sized(3, 1);
    Image image(side, side, {1, 1, 1});
    const auto pixel = [&](int x, int y) {
        Color sum{0, 0, 0};
        for (int i = 0; i < per_side * per_side; ++i) {
            const double dx = (i % per_side + 0.5) / per_side, dy = (i / per_side + 0.5) / per_side;
            const double u = 2 * (x + dx) / side - 1, v = 2 * (y + dy) / side - 1;
            sum += std::hypot(u, v) < 1 ? color(direction_at(u, v)) : Color{1, 1, 1};
        }
        return sum / static_cast<double>(per_side * per_side);
    };
    for_each_tile(side, side, run.threads, "", [&](const Tile& tile) {
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) image.at(x, y) = to_pixel(pixel(x, y));
    });
    return image;
}

void mark_lights(Image& image, const Scene& scene) {
    constexpr std::array names = {"point", "spot", "distant"};
    for (const Light& light : scene.lights) {
        const auto seen = illumination(light, floor_point);
        if (!seen) continue;
        const Point2 at = place_of(seen->to_light);
        draw_disk(image, at, 11, ink::black);
        draw_disk(image, at, 9, {1, 0.85f, 0.2f});
        draw_text(image, {at.x + 16, at.y + 8}, 16, names[light.kind.index()], {1, 1, 1});
    }
}

}  // namespace

Image incoming_light(const Scene& scene, const ChapterRun& run) {
    const auto accelerator = make_accelerator("auto", scene);
    Image arriving = hemisphere(run, [&](const Vec3d& direction) {
        Traversal traversal;
        const Ray ray{.origin = convert<float>(floor_point), .direction = convert<float>(direction)};
        return whitted_color(scene, *accelerator, {.depth = 1}, ray, traversal);
    });
    Image taken = hemisphere(run, [&](const Vec3d&) { return scene.background.ambient; });
    mark_lights(arriving, scene);
    mark_lights(taken, scene);
    return side_by_side({with_caption(arriving, "what arrives at a point of the floor", 18),
                         with_caption(taken, "what a local model takes of it", 18)},
                        40);
}

}  // namespace raylab::lighting
