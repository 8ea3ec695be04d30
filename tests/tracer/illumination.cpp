#include "catch.h"

#include "raylab/tracer/shading/illumination.h"

#include <cmath>
#include <limits>
#include <numbers>

using namespace raylab;

namespace {

Light point_light(const Vec3d& attenuation) {
    return {.kind = PointLight{{0, 2, 0}}, .color = {1, 2, 4}, .attenuation = attenuation};
}

Light spot(double cone, double exponent) {
    return {.kind = SpotLight{.position = {0, 1, 0}, .target = {0, 0, 0}, .cone = cone, .exponent = exponent}};
}

// A point that the spot sees `degrees` off its axis.
Vec3d off_axis(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {std::sin(angle), 1 - std::cos(angle), 0};
}

}  // namespace

TEST_CASE("a point light falls off with the constant, linear and quadratic terms of the distance") {
    for (const double distance : {0.5, 1.0, 2.0, 7.0})
        for (const Vec3d& k : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}, Vec3d{0.5, 0.25, 0.125}}) {
            const auto seen = illumination(point_light(k), {0, 2 - distance, 0});
            REQUIRE(seen);
            CHECK_THAT(seen->color.x, WithinRel(1 / (k.x + k.y * distance + k.z * distance * distance), 1e-14));
            CHECK_THAT(seen->color.z, WithinRel(4 * seen->color.x, 1e-14));
            CHECK(seen->distance == distance);
            CHECK(seen->to_light == Vec3d{0, 1, 0});
        }
}

TEST_CASE("nothing is lit by a light that stands on it, or so near that its falloff vanishes") {
    CHECK_FALSE(illumination(point_light({0, 0, 1}), {0, 2, 0}));
    const Light near_zero{.kind = PointLight{{0, 0, 0}}, .attenuation = {0, 0, 1}};
    CHECK_FALSE(illumination(near_zero, {1e-160, 0, 0}));
    CHECK_FALSE(illumination(near_zero, {1e-300, 0, 0}));
    CHECK(illumination(near_zero, {1e-100, 0, 0}));
}

TEST_CASE("a uniform spot gives all its light inside its cone and none outside") {
    CHECK(illumination(spot(30, 0), off_axis(29.999)).value().color == Color{1, 1, 1});
    CHECK_FALSE(illumination(spot(30, 0), off_axis(30.001)));
    CHECK_FALSE(illumination(spot(90, 0), off_axis(90.001)));
    CHECK_FALSE(illumination(spot(30, 0), off_axis(180)));
}

TEST_CASE("a spot with an exponent gives cos^e of the angle from its axis") {
    for (const double degrees : {0.0, 10.0, 25.0, 44.0}) {
        const auto seen = illumination(spot(45, 3), off_axis(degrees));
        REQUIRE(seen);
        CHECK_THAT(seen->color.x, WithinRel(std::pow(std::cos(degrees * std::numbers::pi / 180), 3), 1e-12));
    }
}

TEST_CASE("the edge of its cone belongs to a spot: one of no width lights its axis") {
    CHECK(illumination(spot(0, 0), off_axis(0)));
    CHECK_FALSE(illumination(spot(0, 0), off_axis(1e-3)));
}

TEST_CASE("a narrow spot has its edge where it says") {
    CHECK(illumination(spot(1e-3, 0), off_axis(0.99e-3)));
    CHECK_FALSE(illumination(spot(1e-3, 0), off_axis(1.01e-3)));
}

TEST_CASE("a distant light comes from its direction everywhere, of whatever length that is") {
    for (const double length : {1e-200, 1.0, 1e200}) {
        const Light sun{.kind = DistantLight{Vec3d{0, -3, -4} * length}, .color = {1, 2, 3}};
        for (const Vec3d& point : {Vec3d{0, 0, 0}, Vec3d{1e6, -3, 2}}) {
            const auto seen = illumination(sun, point);
            REQUIRE(seen);
            CHECK_THAT(glm::length(seen->to_light - Vec3d{0, 0.6, 0.8}), WithinAbs(0, 1e-15));
            CHECK(seen->color == Color{1, 2, 3});
            CHECK(std::isinf(seen->distance));
        }
    }
}
