#include "catch.h"

#include "raylab/sampling/sequence.h"
#include "raylab/transport/path/expected_error.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace raylab;

namespace {

// A picture of pixels whose summands are 1 with chance p, else 0: noisy, and skewed where p is small.
struct Trial {
    double error, bound;
};

Trial trial(double p, int summands, int side, std::uint64_t seed) {
    SampledImage image(side, side);
    double squares = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            RandomSequence random(seed, static_cast<std::uint64_t>(y * side + x));
            for (int i = 0; i < summands; ++i) image.at(x, y).add(Vec3d(random.next() < p ? 1 : 0));
            const double mean = image.at(x, y).color.g / summands;
            squares += (mean - p) * (mean - p);
        }
    return {std::sqrt(squares / (side * side)) / p, expected_error(image).bound};
}

}  // namespace

TEST_CASE("of 400 pictures 91 % and more have an error below the bound, and it is not far above") {
    for (const double p : {0.5, 0.1, 0.02}) {
        int below = 0;
        std::vector<double> ratios;
        for (std::uint64_t seed = 0; seed < 400; ++seed) {
            const auto [error, bound] = trial(p, 128, 16, seed);
            below += error <= bound;
            ratios.push_back(bound / error);
        }
        std::ranges::nth_element(ratios, ratios.begin() + 200);
        INFO("p = " << p << ": " << below << " of 400 below, bound / error " << ratios[200]);
        CHECK(below >= 0.91 * 400);
        CHECK(ratios[200] <= 2);
    }
}
