#include "raylab/image/srgb_bytes.h"

#include "catch.h"
#include "raylab/image/color.h"
#include "raylab/sampling/random.h"

#include <cmath>
#include <limits>

using namespace raylab;

namespace {

void check_like_one_by_one(const std::vector<float>& lights) {
    Image image(static_cast<int>(lights.size()), 1);
    for (std::size_t i = 0; i < lights.size(); ++i) image.at(static_cast<int>(i), 0) = {0, lights[i], 1};
    const auto bytes = srgb_bytes(image);
    REQUIRE(bytes.size() == 3 * lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (bytes[3 * i + 1] == srgb_byte(lights[i])) continue;
        FAIL("light " << lights[i] << ": " << int{bytes[3 * i + 1]} << " instead of " << int{srgb_byte(lights[i])});
    }
}

}  // namespace

TEST_CASE("a picture's bytes are those of its values one by one: around every step between two codes") {
    std::vector<float> lights;
    for (int code = 0; code < 255; ++code) {
        auto light = static_cast<float>(linear_from_srgb((code + 0.5) / 255));
        for (int i = 0; i < 100; ++i) light = std::nextafter(light, 0.0f);
        for (int i = 0; i < 200; ++i) lights.push_back(light = std::nextafter(light, 1.0f));
    }
    check_like_one_by_one(lights);
}

TEST_CASE("a picture's bytes are those of its values one by one: anywhere, and beyond what a screen can show") {
    std::vector<float> lights = {0,
                                 -0.0f,
                                 -1,
                                 1,
                                 std::nextafter(1.0f, 0.0f),
                                 std::nextafter(1.0f, 2.0f),
                                 1e30f,
                                 1e-45f,
                                 std::numeric_limits<float>::infinity(),
                                 std::numeric_limits<float>::quiet_NaN()};
    for (std::uint64_t i = 0; i < 100'000; ++i) lights.push_back(static_cast<float>(random_number({.pixel = i})));
    for (int i = 0; i <= 4096; ++i) lights.push_back(static_cast<float>(i) / 4096);
    check_like_one_by_one(lights);
}
