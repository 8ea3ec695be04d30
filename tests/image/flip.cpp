#include "catch.h"

#include "raylab/image/flip.h"

using namespace raylab;

namespace {

Image plain(const Pixel& color) { return Image(24, 24, color); }

// Gradients and stripes; `test` also has a rectangle and one white pixel.
struct Pair {
    Image reference{32, 24}, test{32, 24};
};

Pair pair() {
    Pair result;
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 32; ++x) {
            const Pixel p{static_cast<float>(x) / 31, static_cast<float>(y) / 23, static_cast<float>((x + y) % 4) / 3};
            const bool inside = y >= 8 && y < 16 && x >= 10 && x < 20;
            result.reference.at(x, y) = p;
            result.test.at(x, y) = inside ? Pixel{0.5f, 0.25f, 0} : p;
        }
    result.test.at(5, 3) = {1, 1, 1};
    return result;
}

}  // namespace

TEST_CASE("a picture does not differ from itself") {
    const ErrorMap map = flip(pair().test, pair().test);
    for (const double value : map.values) CHECK(value == 0.0);
}

TEST_CASE("green against blue is the largest difference there is") {
    CHECK_THAT(flip(plain({0, 1, 0}), plain({0, 0, 1})).mean(), WithinAbs(1, 1e-12));
}

TEST_CASE("black against white, plain: HyAB 100, no feature, so equation (4) alone") {
    // Hunt-adjusted green and blue are 308.11 apart; 0.95 + (100^0.7 / 308.11^0.7 - 0.4) / 0.6 * 0.05.
    CHECK_THAT(flip(plain({0, 0, 0}), plain({1, 1, 1})).at(12, 12), WithinAbs(0.9673797618773927, 1e-9));
}

TEST_CASE("FLIP agrees with the authors' method, filters not separated, evaluated apart") {
    // Values of the published Python code (NVlabs, flip_api.py), transcribed to numpy with full two-dimensional
    // kernels.
    const ErrorMap map = flip(pair().reference, pair().test);
    CHECK_THAT(map.mean(), WithinAbs(0.152294922819883, 1e-6));
    CHECK_THAT(map.at(5, 3), WithinAbs(0.3895344981246891, 1e-6));
    CHECK_THAT(map.at(15, 12), WithinAbs(0.8707573757405713, 1e-6));
    CHECK_THAT(map.at(9, 10), WithinAbs(0.39881758958064817, 1e-6));
    CHECK_THAT(map.at(0, 0), WithinAbs(0.006612485880139485, 1e-6));
    const ErrorMap far = flip(pair().reference, pair().test, 20);
    CHECK_THAT(far.mean(), WithinAbs(0.11526458063904471, 1e-6));
    CHECK_THAT(far.at(5, 3), WithinAbs(0.9836302777020134, 1e-6));
}

TEST_CASE("it does not matter which picture is the reference") {
    CHECK(flip(pair().reference, pair().test).values == flip(pair().test, pair().reference).values);
}

TEST_CASE("a larger change of one grey is a larger difference") {
    double before = 0;
    for (int step = 1; step <= 10; ++step) {
        const float grey = 0.2f + 0.08f * static_cast<float>(step);
        const double now = flip(plain({0.2f, 0.2f, 0.2f}), plain({grey, grey, grey})).mean();
        CHECK(now > before);
        before = now;
    }
    CHECK(before < 1);
}

TEST_CASE("values that a screen cannot show look like those it can") {
    CHECK(flip(plain({1, 1, 1}), plain({5, 2, 9})).mean() == 0);
}
