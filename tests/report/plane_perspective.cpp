#include "raylab/report/plane/plane_perspective.h"

#include "catch.h"

using namespace raylab;
using Catch::WithinAbs;

namespace {

CameraFrame frame() { return camera_frame({.position = {1, 2, 9}, .target = {0, 1, 0}}, {300, 200}); }

}  // namespace

TEST_CASE("in perspective a point stands where the ray of its pixel goes") {
    const CameraFrame camera = frame();
    const PlanePerspective view(camera);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {300.0, 200.0}, {110.5, 33.5}}) {
        const auto ray = picture_ray(camera, x, y);
        const PlanePoint seen = view.at(ray.origin + ray.direction * 7.0);
        CHECK_THAT(seen.x, WithinAbs(camera.half_width * (2 * x / 300 - 1), 1e-12));
        CHECK_THAT(seen.y, WithinAbs(camera.half_height * (1 - 2 * y / 200), 1e-12));
    }
}

TEST_CASE("a ball before the eye is an outline about its centre, and behind the eye nothing") {
    const PlanePerspective view(frame());
    const auto seen = view.figure(wires_of(Sphere{{0, 1, 0}, 0.5f}, 0, {}).at(0));
    REQUIRE(seen);
    const double expected = 0.5 / glm::length(Vec3d{1, 1, 9});
    for (const PlanePoint& corner : std::get<PlanePolygon>(*seen).corners)
        CHECK_THAT(std::hypot(corner.x, corner.y), WithinAbs(expected, 0.05 * expected));
    CHECK_FALSE(view.figure(wires_of(Sphere{{1, 2, 12}, 0.5f}, 0, {}).at(0)));
}
