#include "catch.h"
#include "transport/sampled.h"

#include <fmt/format.h>

#include <array>
#include <numbers>

// Pictures of what moves while the shutter is open, against closed forms: what a pixel shows is the share of the time
// in which something covers it.

using namespace raylab;
using namespace raylab::test;

namespace {

// The picture's plane is z = 0; a pixel is half a metre.
std::string parallel_view(int width, int height, const std::string& shutter) {
    return fmt::format("[image]\nwidth = {}\nheight = {}\n[camera]\ntype = \"orthographic\"\nheight = {}\n"
                       "position = [0, 0, 5]\ntarget = [0, 0, 0]\nshutter = {}\n",
                       width, height, height / 2.0, shutter) +
           "[material.bright]\nemission = [1, 1, 1]\ndiffuse = [0, 0, 0]\n";
}

double mean_at(const SampledImage& image, int x, int y) { return image.at(x, y).color.g / image.at(x, y).count; }

// Of 100 pixels one is so far off by chance in one of 5000 runs.
constexpr double farthest = 4.9;

void check_pixel(const SampledImage& image, int x, int y, double truth) {
    const double error = std::sqrt(image.variance_of_mean(x, y));
    INFO("pixel " << x << " " << y << ": " << mean_at(image, x, y) << " +- " << error << ", truth " << truth);
    CHECK(std::abs(mean_at(image, x, y) - truth) <= farthest * error + 1e-12);
}

// The integral of 2 sqrt(r^2 - y^2) from 0.
double half_disk_area(double r, double y) { return y * std::sqrt(r * r - y * y) + r * r * std::asin(y / r); }

// The bright side of an edge at x = `at_zero` when t is zero, which goes 2 m a second.
SampledImage moving_edge(const std::string& shutter, double at_zero, int samples) {
    return Sampled(parallel_view(8, 2, shutter) + fmt::format(R"(
[[shape]]
type = "polygon"
vertices = [[{0}, -9, 0], [{1}, -9, 0], [{1}, 9, 0], [{0}, 9, 0]]
motion = [2, 0, 0]
material = "bright"
)",
                                                              at_zero - 9, at_zero))
        .sampled(samples);
}

double center_of(int x) { return -1.75 + 0.5 * x; }

}  // namespace

// The edge goes from x = -1 to 1 while the shutter is open: a ramp as wide as the way is long. Where it is when the
// shutter opens depends on when that is.
TEST_CASE("a straight edge that moves is a linear ramp") {
    for (const auto& [shutter, at_zero] : {std::pair{"[0, 1]", -1.0}, {"[0.5, 1.5]", -2.0}, {"[-1, 0]", 1.0}}) {
        INFO("shutter " << shutter);
        const SampledImage image = moving_edge(shutter, at_zero, 1 << 14);
        for (int x = 0; x < 8; ++x)
            for (int y = 0; y < 2; ++y) check_pixel(image, x, y, std::clamp((1 - center_of(x)) / 2, 0.0, 1.0));
    }
}

TEST_CASE("a ramp's slope says the speed, and one that is wrong by 1 % is found", "[long]") {
    const SampledImage image = moving_edge("[0, 1]", -1, 1 << 18);
    double slope = 0, squares = 0, variance = 0;  // by least squares, of the pixels on the ramp
    for (int x = 2; x < 6; ++x)
        for (int y = 0; y < 2; ++y) {
            const double center = center_of(x);
            slope += center * mean_at(image, x, y);
            squares += center * center;
            variance += center * center * image.variance_of_mean(x, y);
        }
    CHECK(std::abs(slope + 0.5 * squares) <= 4 * std::sqrt(variance));
    CHECK(std::abs(slope + 0.5 / 1.01 * squares) > 4 * std::sqrt(variance));
}

// A disk of radius r that goes the way L covers a point at height y for 2 sqrt(r^2 - y^2) / L of the time, wherever
// along the way, but for its ends: what it covers in all is its area at any moment.
TEST_CASE("a disk that moves covers what its height says, and in all its area") {
    constexpr double radius = 0.75, way = 2.5;
    const std::string shape = R"(
[[shape]]
type = "disk"
center = [-1.25, 0, 0]
normal = [0, 0, 1]
radius = 0.75
motion = [2.5, 0, 0]
material = "bright"
)";
    for (const std::string& moved : {shape, std::string(R"([group.wheel]
shapes = [{ type = "sphere", center = [0, 0, 0], radius = 0.75, material = "bright", motion = [1, 0, 0] }]
[[instance]]
of = "wheel"
transform = [{ translate = [-1.25, 0, 0] }]
motion = [1.5, 0, 0]
)")}) {
        const SampledImage image = Sampled(parallel_view(8, 4, "[0, 1]") + moved).sampled(1 << 16);
        double sum = 0, variance = 0;
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 8; ++x) {
                sum += 0.25 * mean_at(image, x, y);
                variance += 0.0625 * image.variance_of_mean(x, y);
            }
        const double area = std::numbers::pi * radius * radius, error = std::sqrt(variance);
        INFO(sum << " +- " << error << ", area " << area);
        CHECK(std::abs(sum - area) <= 4 * error);
        CHECK(std::abs(sum - 1.01 * area) > 4 * error);
        // In the middle of the way the disk comes and goes in every pixel: |x| <= L / 2 - r.
        for (const int x : {3, 4})
            for (const int y : {1, 2}) {
                const double truth = half_disk_area(radius, 0.5) / way / 0.5;
                check_pixel(image, x, y, truth);
            }
    }
}

TEST_CASE("while the shutter is open for an instant, what moves stands where it is then") {
    const Sampled still(parallel_view(8, 2, "[0.5, 0.5]") + R"(
[[shape]]
type = "polygon"
vertices = [[0, -9, 0], [0.5, -9, 0], [0.5, 9, 0], [0, 9, 0]]
motion = [2, 0, 0]
material = "bright"
)");
    const SampledImage image = still.sampled(64);
    for (int x = 0; x < 8; ++x) CHECK(mean_at(image, x, 0) == (x == 6 ? 1 : 0));
}

// It goes through the pixels in front of the light, for a third of the time each: shadow rays have the path's time.
TEST_CASE("a shadow moves with what casts it") {
    const Sampled floor(parallel_view(2, 2, "[0, 3]") + R"(
[material.dark]
diffuse = [0, 0, 0]
[material.floor]
diffuse = [1, 1, 1]
[[light]]
type = "distant"
direction = [0, 0.6, -0.8]
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
material = "floor"
[[shape]]
type = "polygon"
vertices = [[-1.5, -19, 4], [-0.5, -19, 4], [-0.5, -1, 4], [-1.5, -1, 4]]
motion = [1, 0, 0]
material = "dark"
)");
    // Lit in two of three seconds; half of a pixel's width is 0.25.
    const SampledImage image = floor.sampled(1 << 14);
    for (int x = 0; x < 2; ++x)
        for (int y = 0; y < 2; ++y) check_pixel(image, x, y, 0.8 * 2 / 3);
}

// A sphere of radius 1 goes up from 2 to 4 above the floor: the irradiance over pi, (R / d)^2, is in the mean
// R^2 / (2 * 4). Points on the light are found where it is then, and weighed with the lobes' directions that hit it.
TEST_CASE("a light that moves shines from where it is", "[long]") {
    const std::string scene = R"(
[image]
width = 4
height = 4
[camera]
position = [0, 0.5, 0]
target = [0, 0, 0]
up = [0, 0, 1]
fov_y = 1e-6
shutter = [1, 3]
[material.floor]
diffuse = [1, 1, 1]
[material.light]
emission = [1, 1, 1]
diffuse = [0, 0, 0]
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
[[shape]]
type = "sphere"
center = [0, 1, 0]
radius = 1
motion = [0, 1, 0]
material = "light"
)";
    for (const LightStrategy strategy : {LightStrategy::lights, LightStrategy::lobes, LightStrategy::both}) {
        const SampledImage image = Sampled(scene, {.followed = Followed::all, .strategy = strategy})
                                       .sampled(1 << (strategy == LightStrategy::lobes ? 16 : 14));
        INFO("strategy " << static_cast<int>(strategy) << ": " << deviations(image, 0.125));
        CHECK(std::abs(deviations(image, 0.125)) <= 4);
        CHECK(std::abs(deviations(image, 0.125 * 1.02)) > 4);
    }
}

// A disk whose radius grows from R to 2 R, a height h above the floor: the irradiance over pi, r^2 / (r^2 + h^2), is in
// the mean 1 - h (atan(2 R / h) - atan(R / h)) / R.
TEST_CASE("a light that stretches shines from all of what it is", "[long]") {
    const std::string scene = R"(
[image]
width = 4
height = 4
[camera]
position = [0, 0.5, 0]
target = [0, 0, 0]
up = [0, 0, 1]
fov_y = 1e-6
shutter = [0, 1]
[material.floor]
diffuse = [1, 1, 1]
[material.bright]
emission = [1, 1, 1]
diffuse = [0, 0, 0]
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "floor"
[[shape]]
type = "disk"
center = [0, 2, 0]
normal = [0, -1, 0]
radius = 1
transform_end = [{ scale = [2, 1, 2] }]
material = "bright"
)";
    const double truth = 1 - 2 * (std::atan(1) - std::atan(0.5));
    for (const LightStrategy strategy : {LightStrategy::lights, LightStrategy::lobes, LightStrategy::both}) {
        const Sampled stage(scene, {.followed = Followed::all, .strategy = strategy});
        CHECK(stage.picture.unsampled().empty());
        const SampledImage image = stage.sampled(1 << 14);
        INFO("strategy " << static_cast<int>(strategy) << ": " << deviations(image, truth));
        CHECK(std::abs(deviations(image, truth)) <= 4);
        CHECK(std::abs(deviations(image, truth * 1.02)) > 4);
    }
}

TEST_CASE("a square that grows covers what it should, where it is seen itself") {
    // Twice as large in the end: seen straight on, it covers x^2 of the picture's 16, in the mean 7/3.
    const Sampled growing(parallel_view(8, 8, "[0, 1]") + R"(
[[shape]]
type = "polygon"
vertices = [[-0.5, -0.5, 0], [0.5, -0.5, 0], [0.5, 0.5, 0], [-0.5, 0.5, 0]]
transform_end = [{ scale = 2 }]
material = "bright"
)");
    const SampledImage image = growing.sampled(1 << 14);
    double sum = 0, variance = 0;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            sum += 0.25 * mean_at(image, x, y);
            variance += 0.0625 * image.variance_of_mean(x, y);
        }
    INFO(sum << " +- " << std::sqrt(variance));
    CHECK(std::abs(sum - 7.0 / 3) <= 4 * std::sqrt(variance));
    CHECK(std::abs(sum - 1.01 * 7 / 3) > 4 * std::sqrt(variance));
}
