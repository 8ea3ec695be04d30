#include "catch.h"
#include "povray.h"
#include "transport/sampled.h"

#include <fmt/format.h>

#include <numbers>

// Area lights and lenses in POV-Ray's words. Both renderers' pictures are noisy, and a closed form judges each.

using namespace raylab;
using namespace raylab::test;

namespace {

double mean_of(const Image& image) {
    double sum = 0;
    for (const Pixel& pixel : image.pixels()) sum += pixel.g / static_cast<double>(image.pixels().size());
    return sum;
}

// POV-Ray's time for more rays through a lens grows with their square.
// The mean of both pictures of a scene whose pixels are all `truth`, within the same share of it.
void check_both(const std::string& text, double truth, double share) {
    const Sampled ours(text);
    CHECK_THAT(mean_of(ours.sampled(1024).mean()), WithinRel(truth, share));
    if (const auto theirs = povray_picture(ours.scene, {.samples = 400}))
        CHECK_THAT(mean_of(*theirs), WithinRel(truth, share));
}

std::string floor_below(const std::string& light) {
    return R"(
[image]
width = 8
height = 8
[camera]
type = "orthographic"
position = [0, 0, 0.5]
target = [0, 0, 0]
up = [0, 1, 0]
height = 0.01
[material.floor]
diffuse = [1, 1, 1]
[material.bright]
diffuse = [0, 0, 0]
emission = [1, 1, 1]
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
material = "floor"
[[shape]]
material = "bright"
)" + light;
}

}  // namespace

TEST_CASE("POV-Ray's area lights are as bright as ours: a disk, a sphere, a rectangle beside a screen") {
    check_both(floor_below("type = \"disk\"\ncenter = [0, 0, 2]\nnormal = [0, 0, -1]\nradius = 0.5\n"),
               0.25 / (0.25 + 4), 0.01);
    check_both(floor_below("type = \"sphere\"\ncenter = [0, 0, 4]\nradius = 0.25\n"), 1.0 / 256, 0.01);
    // Half of the light is hidden: the penumbra of a half-plane.
    check_both(floor_below(R"(type = "polygon"
vertices = [[-0.5, -0.5, 2], [-0.5, 0.5, 2], [0.5, 0.5, 2], [0.5, -0.5, 2]]
[[shape]]
type = "polygon"
vertices = [[-50, -50, 1], [0, -50, 1], [0, 50, 1], [-50, 50, 1]]
)"),
               .036738817406261, 0.02);
}

TEST_CASE("POV-Ray's focal blur is our lens: an edge at twice the distance of the focus") {
    constexpr double s = 0.5, radius = 0.125, focus = 4;
    check_both(fmt::format(R"(
[image]
width = 8
height = 8
[camera]
position = [0, 0, 0]
target = [{}, 0, {}]
fov_y = 0.001
lens = {{ radius = {}, focus = {} }}
[material.bright]
diffuse = [0, 0, 0]
emission = [1, 1, 1]
[[shape]]
type = "polygon"
vertices = [[0, -9, -8], [9, -9, -8], [9, 9, -8], [0, 9, -8]]
material = "bright"
)",
                           s * radius / 2, -focus, radius, focus),
               0.5 + (s * std::sqrt(1 - s * s) + std::asin(s)) / std::numbers::pi, 0.01);
}
