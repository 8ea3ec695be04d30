#include "transport/verdict.h"

#include "catch.h"
#include "transport/sampled.h"

#include "raylab/sampling/sequence.h"

#include <fmt/format.h>

using namespace raylab;
using namespace raylab::test;

namespace {

constexpr int side = 16, samples = 1024;
constexpr double p = 0.3;

// A picture of samples that are 1 with chance `chance`, else 0.
SampledImage coins(double chance, std::uint64_t seed) {
    SampledImage image(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            RandomSequence random(seed, static_cast<std::uint64_t>(y * side + x));
            for (int i = 0; i < samples; ++i) image.at(x, y).add(Vec3d(random.next() < chance ? 1 : 0));
        }
    return image;
}

int alarms(double chance, int pictures) {
    int all = 0;
    for (int seed = 0; seed < pictures; ++seed)
        all += !deviation(coins(chance, static_cast<std::uint64_t>(seed)), [](int, int) {
                    return p;
                }).could_be_chance(0.005);
    return all;
}

}  // namespace

// Of 64 x 64 x 3 values one is beyond 4.931 in a hundred pictures (Sidak's limit as published with Mitsuba's test).
TEST_CASE("Sidak's limit is the one that is published") {
    CHECK_THAT(sidak_limit(64 * 64 * 3, 0.01), WithinAbs(4.931, 5e-4));
    CHECK_THAT(sidak_limit(64 * 64 * 3, 0.001), WithinAbs(5.364, 5e-4));
    CHECK_THAT(sidak_limit(1, 0.05), WithinAbs(1.95996, 1e-5));
}

// At .005 each, 2 of 200 right pictures are expected to be accused, and ten or more in one of 20 000 runs. Of pictures
// that are 1 % too bright, 3.4 standard errors of the mean, three quarters are found.
TEST_CASE("of right pictures a hundredth is accused, of pictures 1 % too bright most are") {
    CHECK(alarms(p, 200) < 10);
    CHECK(alarms(1.01 * p, 100) > 50);
}

TEST_CASE("a slanted edge through the box filter: each pixel against the area of it that is covered") {
    const Sampled edge(R"(
[image]
width = 16
height = 16
[camera]
type = "orthographic"
height = 16
position = [0.3, 0.2, 5]
target = [0.3, 0.2, 0]
[material.bright]
emission = [1, 1, 1]
diffuse = [0, 0, 0]
[[shape]]
type = "polygon"
vertices = [[-40, -20, 0], [20, -20, 0], [-40, 40, 0]]
material = "bright"
)");
    // The long side is x + y = 0. Of a unit square whose centre is at x + y = s, beyond the edge a corner is covered,
    // of area (1 - |s|)^2 / 2; on the bright side all but such a corner is.
    const auto coverage = [](int x, int y) {
        const double center = (0.3 + x - 7.5) + (0.2 + 7.5 - y), beyond = 1 - std::abs(center);
        const double corner = beyond > 0 ? beyond * beyond / 2 : 0;
        return center > 0 ? corner : 1 - corner;
    };
    const SampledImage image = edge.sampled(1 << 13);
    const Deviation found = deviation(image, coverage);
    INFO(found.mean << " and " << found.greatest << " standard errors, limit " << sidak_limit(found.pixels, 1e-5));
    CHECK(found.could_be_chance(1e-5));
    CHECK_FALSE(deviation(image, [&](int x, int y) { return 1.01 * coverage(x, y); }).could_be_chance(1e-5));
}
