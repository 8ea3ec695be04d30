#include "catch.h"
#include "transport/sampled.h"

#include <fmt/format.h>

#include <numbers>

// How fast the error of a picture falls with its samples, one effect at a time. All pixels of these pictures see the
// same, each with random numbers of its own: 208 pixels are as many seeds.

using namespace raylab;
using namespace raylab::test;

namespace {

// The slope of the line through log RMSE over log N, for N = 16, 64, ..., 4096.
double picture_slope(const Sampled& stage, SamplerKind kind, double truth) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (int count = 16; count <= 4096; count *= 4) {
        SampledImage image(stage.scene.image.width, stage.scene.image.height);
        stage.picture.add(image, {kind, count, 1}, {0, count}, Summand::sample);
        double squares = 0, pixels = 0;
        for (int py = 0; py < image.height(); ++py)
            for (int px = 0; px < image.width(); ++px, ++pixels)
                squares += std::pow(image.at(px, py).color.g / count - truth, 2);
        const double at = std::log(count), error = 0.5 * std::log(squares / pixels);
        n += 1;
        x += at;
        y += error;
        xx += at * at;
        xy += at * error;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

const std::string pixels = "[image]\nwidth = 16\nheight = 13\n";

}  // namespace

TEST_CASE("the picture of an edge behind a lens: random -1/2, jittered -3/4, scrambled Sobol -3/4") {
    constexpr double s = 0.25, radius = 0.125, focus = 4;
    const Sampled edge(pixels + fmt::format(R"(
[camera]
position = [0, 0, 0]
target = [{}, 0, {}]
fov_y = 1e-6
lens = {{ radius = {}, focus = {} }}
[material.bright]
diffuse = [0, 0, 0]
emission = [1, 1, 1]
[[shape]]
type = "polygon"
vertices = [[0, -9, -8], [9, -9, -8], [9, 9, -8], [0, 9, -8]]
material = "bright"
)",
                                            s * radius / 2, -focus, radius, focus));
    const double truth = 0.5 + (s * std::sqrt(1 - s * s) + std::asin(s)) / std::numbers::pi;
    CHECK_THAT(picture_slope(edge, SamplerKind::random, truth), WithinAbs(-0.5, 0.08));
    CHECK_THAT(picture_slope(edge, SamplerKind::jittered, truth), WithinAbs(-0.75, 0.08));
    CHECK_THAT(picture_slope(edge, SamplerKind::sobol, truth), WithinAbs(-0.75, 0.08));
}

TEST_CASE("the picture of a floor below an area light: random -1/2, jittered -1, scrambled Sobol at most -1.4") {
    const Sampled floor(pixels + R"(
[camera]
position = [0, 0, 0.5]
target = [0, 0, 0]
up = [0, 1, 0]
fov_y = 1e-6
[material.floor]
diffuse = [1, 1, 1]
[material.light]
diffuse = [0, 0, 0]
emission = [1, 1, 1]
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
material = "floor"
[[shape]]
type = "polygon"
vertices = [[-0.5, -0.5, 2], [0.5, -0.5, 2], [0.5, 0.5, 2], [-0.5, 0.5, 2]]
material = "light"
)");
    constexpr double truth = .073477634812521;  // the form factor from the floor to the square
    CHECK_THAT(picture_slope(floor, SamplerKind::random, truth), WithinAbs(-0.5, 0.08));
    CHECK_THAT(picture_slope(floor, SamplerKind::jittered, truth), WithinAbs(-1, 0.08));
    CHECK(picture_slope(floor, SamplerKind::sobol, truth) <= -1.4);
}
