#include "catch.h"

#include "raylab/scene/read_scene.h"

#include "hostile/refusals.h"

TEST_CASE("each broken scene is refused, on one line that says what was expected and what was found") {
    check_refusals(RAYLAB_SOURCE "/tests/hostile/scenes", [](const auto& file) { raylab::read_scene(file); });
}
