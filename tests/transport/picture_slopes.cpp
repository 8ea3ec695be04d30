#include "catch.h"
#include "transport/sampled.h"
#include "transport/scene_text.h"

#include <numbers>

// How fast the error of a picture falls with its samples, one effect at a time. All pixels of these pictures see the
// same, each with random numbers of its own: 200 pixels, of one seed or of several.

using namespace raylab;
using namespace raylab::test;

namespace {

// The slope of the line through log RMSE over log N, for N = 16, 64, ..., 4096.
double picture_slope(const Sampled& stage, SamplerKind kind, double truth) {
    const int width = stage.scene.image.width, height = stage.scene.image.height;
    const int threads = width * height < 100 ? 1 : 0;
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (int count = 16; count <= 4096; count *= 4) {
        double squares = 0, pixels = 0;
        for (std::uint64_t seed = 1; pixels < 200; ++seed) {
            SampledImage image(width, height);
            stage.picture.add(image, {kind, count, seed}, {0, count}, Summand::sample, threads);
            for (int py = 0; py < height; ++py)
                for (int px = 0; px < width; ++px, ++pixels)
                    squares += std::pow(image.at(px, py).color.g / count - truth, 2);
        }
        const double at = std::log(count), error = 0.5 * std::log(squares / pixels);
        n += 1;
        x += at;
        y += error;
        xx += at * at;
        xy += at * error;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

const std::string pixels = image_text(16, 13);

// An edge in two dimensions, or in one.
void check_edge_slopes(const Sampled& stage, double truth, double of_even_samples) {
    CHECK_THAT(picture_slope(stage, SamplerKind::random, truth), WithinAbs(-0.5, 0.08));
    CHECK_THAT(picture_slope(stage, SamplerKind::jittered, truth), WithinAbs(of_even_samples, 0.08));
    CHECK_THAT(picture_slope(stage, SamplerKind::sobol, truth), WithinAbs(of_even_samples, 0.08));
}

}  // namespace

TEST_CASE("the picture of an edge behind a lens: random -1/2, jittered -3/4, scrambled Sobol -3/4", "[long]") {
    constexpr double s = 0.25, radius = 0.125, focus = 4;
    const Sampled edge(pixels +
                       fmt::format("[camera]\nposition = [0, 0, 0]\ntarget = [{}, 0, {}]\nfov_y = 1e-6\n"
                                   "lens = {{ radius = {}, focus = {} }}\n",
                                   s * radius / 2, -focus, radius, focus) +
                       material_text("bright", 0, 1) +
                       polygon_text("[[0, -9, -8], [9, -9, -8], [9, 9, -8], [0, 9, -8]]", "bright"));
    check_edge_slopes(edge, 0.5 + (s * std::sqrt(1 - s * s) + std::asin(s)) / std::numbers::pi, -0.75);
}

TEST_CASE("the picture of a floor below an area light: random -1/2, jittered -1, scrambled Sobol at most -1.4",
          "[long]") {
    const Sampled floor(pixels + floor_below_light_text());
    CHECK_THAT(picture_slope(floor, SamplerKind::random, floor_below_light), WithinAbs(-0.5, 0.08));
    CHECK_THAT(picture_slope(floor, SamplerKind::jittered, floor_below_light), WithinAbs(-1, 0.08));
    CHECK(picture_slope(floor, SamplerKind::sobol, floor_below_light) <= -1.4);
}

TEST_CASE("a light that directions of the lobe find is an edge: random -1/2, jittered -3/4, scrambled Sobol -3/4",
          "[long]") {
    TransportOptions by_lobes = paths();
    by_lobes.strategy = LightStrategy::lobes;
    check_edge_slopes(Sampled(pixels + floor_below_light_text(), by_lobes), floor_below_light, -0.75);
}

// It passes at a third of the time: at a third of one of the jittered intervals, whatever their number here.
TEST_CASE("an edge that moves past: random -1/2; jittered and scrambled Sobol -1, as in one dimension", "[long]") {
    const Sampled edge(
        pixels + "[camera]\nposition = [0, 0, 5]\ntarget = [0, 0, 0]\nfov_y = 1e-6\nshutter = [0, 1]\n" +
        material_text("bright", 0, 1) +
        polygon_text("[[-10, -9, 0], [-1, -9, 0], [-1, 9, 0], [-10, 9, 0]]", "bright", "motion = [3, 0, 0]\n"));
    check_edge_slopes(edge, 2.0 / 3, -1);
}

TEST_CASE("a slanted edge through a pixel of the box filter: random -1/2, jittered -3/4, scrambled Sobol -3/4") {
    const Sampled edge(image_text(1, 1) +
                       "[camera]\ntype = \"orthographic\"\nheight = 1\nposition = [0, 0, 5]\ntarget = [0, 0, 0]\n" +
                       material_text("bright", 0, 1) +
                       polygon_text("[[0.4, 1, 0], [-0.2, -1, 0], [9, -1, 0], [9, 1, 0]]", "bright"));  // x > .3 y + .1
    check_edge_slopes(edge, 0.4, -0.75);
}
