#include "catch.h"

#include "raylab/experiment/generate/architecture.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/generate/uneven.h"
#include "raylab/scene/needs.h"

#include <memory>

// `auto` chooses by the scene, and by how many rays will ask.

using namespace raylab;

namespace {

Scene scene_of(Mesh mesh) {
    Scene scene;
    scene.objects.push_back({.shape = std::make_shared<const Mesh>(std::move(mesh))});
    return scene;
}

}  // namespace

TEST_CASE("planes that cut triangles are chosen where boxes are empty and rays are many") {
    const Scene scene = scene_of(hair(3));
    const auto count = static_cast<double>(primitive_count(scene));
    CHECK(suited_accelerator(scene) == "bvh8");
    CHECK(suited_accelerator(scene, count) == "bvh8");
    CHECK(suited_accelerator(scene, 10 * count) == "bvh8_splits");
}

TEST_CASE("where boxes are well filled, no number of rays pays for them") {
    for (const Scene& scene :
         {scene_of(bumpy_sphere(4)), scene_of(city(2)), scene_of(arcade_hall(2)), scene_of(stadium(2))})
        CHECK(suited_accelerator(scene, 1e12) == "bvh8");
}
