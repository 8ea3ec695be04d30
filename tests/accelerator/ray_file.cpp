#include "raylab/accelerator/ray_file.h"

#include "catch.h"
#include "raylab/base/bytes.h"

#include <cmath>
#include <limits>

using namespace raylab;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
const float no_number = std::nanf("");

const Ray good{.origin = {1, 2, 3}, .direction = {0, 0, -1}, .range = {0.5f, infinity}};

void check_refused(const Ray& bad, const std::string& message) {
    CHECK_THROWS_WITH(rays_from_bytes(to_bytes(std::vector{good, bad, bad}), "a.rays"),
                      "a.rays ray 1: expected " + message);
}

}  // namespace

TEST_CASE("a ray is eight little-endian floats: origin, tmin, direction, tmax") {
    std::string bytes;
    for (const float number : {1.0f, 2.0f, 3.0f, 0.5f, 0.0f, 0.0f, -1.0f, infinity})
        append_number(bytes, number, std::endian::little);
    const auto rays = rays_from_bytes(bytes, "a.rays");
    REQUIRE(rays.size() == 1);
    CHECK(rays[0].origin == good.origin);
    CHECK(rays[0].direction == good.direction);
    CHECK(rays[0].range.min == 0.5f);
    CHECK(rays[0].range.max == infinity);
    CHECK(rays[0].leaving == no_primitive);
    CHECK(to_bytes(rays) == bytes);
    CHECK(bytes.substr(0, 4) == std::string("\0\0\x80\x3f", 4));
}

TEST_CASE("a hit is an int32 and a float32, little-endian") {
    CHECK(to_bytes(std::vector<HitRecord>{{258, 1.0f}, {-1, infinity}}) ==
          std::string("\x02\x01\0\0\0\0\x80\x3f\xff\xff\xff\xff\0\0\x80\x7f", 16));
}

TEST_CASE("a file may hold no ray at all") { CHECK(rays_from_bytes("", "a.rays").empty()); }

TEST_CASE("part of a ray is refused with its number") {
    CHECK_THROWS_WITH(rays_from_bytes(to_bytes(std::vector{good, good}) + "123", "a.rays"),
                      "a.rays ray 2: expected 32 bytes, found 3");
    CHECK_THROWS_WITH(rays_from_bytes("1", "a.rays"), "a.rays ray 0: expected 32 bytes, found 1");
}

TEST_CASE("a ray with a number that is none is refused with its number") {
    auto bad = good;
    bad.origin.y = no_number;
    check_refused(bad, "a finite origin, found (1, nan, 3)");
    bad = good;
    bad.origin.x = -infinity;
    check_refused(bad, "a finite origin, found (-inf, 2, 3)");
    bad = good;
    bad.direction.z = infinity;
    check_refused(bad, "a finite direction, found (0, 0, inf)");
    bad = good;
    bad.direction = {0, -0.0f, 0};
    check_refused(bad, "a direction that is not zero, found (0, -0, 0)");
    bad = good;
    bad.range.min = -infinity;
    check_refused(bad, "a finite tmin, found -inf");
    bad = good;
    bad.range.max = no_number;
    check_refused(bad, "a tmax that is finite or +infinity, found nan");
    bad = good;
    bad.range.max = -infinity;
    check_refused(bad, "a tmax that is finite or +infinity, found -inf");
}

TEST_CASE("odd rays that have a meaning are accepted") {
    auto odd = good;
    odd.range = {-3.0f, -4.0f};                                        // an empty range
    odd.direction = {std::numeric_limits<float>::denorm_min(), 0, 0};  // short, but not zero
    CHECK(rays_from_bytes(to_bytes(std::vector{odd}), "a.rays").size() == 1);
}
