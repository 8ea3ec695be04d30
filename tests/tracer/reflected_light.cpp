#include "catch.h"

#include "raylab/tracer/shading/reflected_light.h"

#include <cmath>

using namespace raylab;

namespace {

// 0.6 and 0.8 are the cosines of a light to the left of the normal and of a viewer to the right.
const Illumination light{.to_light = {-0.8, 0, 0.6}, .distance = 1, .color = {1, 2, 4}};
const Material shiny{.name = "shiny", .specular = {0.25, 0.5, 1}, .shininess = 3};

LitPoint seen_from(const Vec3d& to_viewer) {
    return {.position = {0, 0, 0}, .normal = {0, 0, 1}, .to_viewer = to_viewer};
}

}  // namespace

TEST_CASE("a light gives its colour times the diffuse cosine and the highlight") {
    const Color seen = reflected_light(light, seen_from({0.6, 0, 0.8}), {0.5, 0.25, 0.125}, shiny);
    const double highlight = std::pow(0.8 * 0.6 + 0.6 * 0.8, 3);
    CHECK_THAT(seen.x, WithinRel(1 * (0.5 * 0.6 + 0.25 * highlight), 1e-14));
    CHECK_THAT(seen.y, WithinRel(2 * (0.25 * 0.6 + 0.5 * highlight), 1e-14));
    CHECK_THAT(seen.z, WithinRel(4 * (0.125 * 0.6 + 1 * highlight), 1e-14));
}

TEST_CASE("the diffuse part is the same for every viewer") {
    const Material matte{.name = "matte"};
    CHECK(reflected_light(light, seen_from({0.6, 0, 0.8}), {1, 1, 1}, matte) ==
          reflected_light(light, seen_from({0, 0, 1}), {1, 1, 1}, matte));
}

TEST_CASE("a light behind the surface gives nothing, and takes nothing away") {
    const Illumination behind{.to_light = {0.8, 0, -0.6}, .distance = 1, .color = {1, 1, 1}};
    CHECK(reflected_light(behind, seen_from({0.6, 0, 0.8}), {1, 1, 1}, shiny) == Color{0, 0, 0});
}
