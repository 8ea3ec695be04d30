#include "scenes.h"

#include "catch.h"

#include "raylab/sampling/sequence.h"
#include "raylab/tracer/shading/ray_start.h"

#include <cmath>
#include <limits>

// The beginning and the end of a ray that leaves a surface.

using namespace raylab;
using namespace raylab::test;

namespace {

constexpr double error = 1e-3;  // metres, ten thousand times the spacing of floats at these points

struct Left {
    SurfacePoint surface;
    Vec3d direction;
    Vec3d normal;  // on the ray's side
};

Left any_surface(RandomSequence& random) {
    const Vec3d normal = random.unit_vector(), direction = random.unit_vector();
    const SurfacePoint surface{.position = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)},
                               .error = error,
                               .normal = normal,
                               .shading_normal = normal,
                               .object = nullptr,
                               .primitive = {3, 5}};
    return {surface, direction, dot(normal, direction) < 0 ? -normal : normal};
}

Ray leaving(const Left& left, double length) { return ray_from(left.surface, left.direction, length, {}, {}, 0); }

}  // namespace

TEST_CASE("a ray begins farther from its surface than the point may be wrong, on the side that it goes to") {
    RandomSequence random(6, 0);
    for (int i = 0; i < 500; ++i) {
        const Left left = any_surface(random);
        const Vec3d step = convert<double>(leaving(left, 2).origin) - left.surface.position;
        CHECK(dot(step, left.normal) > error);
        CHECK(glm::length(step) < 2 * error);
    }
}

TEST_CASE("a ray of a given length ends where it would end from the surface itself") {
    RandomSequence random(7, 0);
    for (int i = 0; i < 500; ++i) {
        const Left left = any_surface(random);
        const Ray ray = leaving(left, 2);
        const double advance = dot(convert<double>(ray.origin) - left.surface.position, left.direction);
        CHECK_THAT(advance + ray.range.max, WithinAbs(2, 1e-6));
    }
}

TEST_CASE("a ray without end has none, and one that begins beyond its length has no room left") {
    RandomSequence random(8, 0);
    for (int i = 0; i < 100; ++i) {
        const Left left = any_surface(random);
        CHECK(std::isinf(leaving(left, std::numeric_limits<double>::infinity()).range.max));
        CHECK(leaving({left.surface, left.normal, left.normal}, error / 2).range.max == 0);
        CHECK(leaving(left, 1).leaving == Primitive{3, 5});
    }
}

TEST_CASE(
    "without an error bound a ray begins where it is told to: on the surface or along the ray that arrived, and so far "
    "on") {
    const SurfacePoint surface{.position = {1, 2, -30},
                               .error = error,
                               .normal = {0, 1, 0},
                               .shading_normal = {0, 1, 0},
                               .object = nullptr,
                               .primitive = {}};
    const Ray arrived{{5, 6, 7}, {1, 0, -2}};
    const auto begun = [&](const RayStart& start) { return ray_from(surface, {0, 1, 0}, 2, start, arrived, 3); };
    CHECK(begun({.offset = RayStart::Offset::none}).origin == Vec3f{1, 2, -30});
    CHECK(begun({.point = RayStart::Point::along_ray, .offset = RayStart::Offset::none}).origin == Vec3f{8, 6, 1});
    CHECK(begun({.offset = RayStart::Offset::none}).range.min == 0);
    CHECK(begun({.offset = RayStart::Offset::fixed, .amount = 0.25}).range.min == 0.25f);
    CHECK(begun({.offset = RayStart::Offset::scaled, .amount = 0.25}).range.min ==
          7.5f);  // of the largest coordinate, whatever its sign
}

TEST_CASE("a surface that a light lies on does not shade what the light shines upon") {
    const Stage stage(R"(
[[light]]
type = "point"
position = [0.3, 3, 0.2]
[[shape]]
type = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
[[shape]]
type = "plane"
point = [0, 3, 0]
normal = [0, 1, 0]
)");
    RandomSequence random(9, 0);
    int lit = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto shadow_rays =
            of_kind(stage.tree({random.between(-4, 4), 1, random.between(-4, 4)}, {0, -1, 0}), RayKind::shadow);
        REQUIRE(shadow_rays.size() == 1);
        lit += shadow_rays[0].ended == Ending::reached;
    }
    CHECK(lit == 1000);
}
