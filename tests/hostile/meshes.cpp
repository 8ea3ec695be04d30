#include "catch.h"

#include "raylab/scene/mesh/read_mesh.h"

#include "hostile/refusals.h"

TEST_CASE("each broken mesh is refused, on one line that says what was expected and what was found") {
    check_refusals(RAYLAB_SOURCE "/tests/hostile/meshes", [](const auto& file) { raylab::read_mesh(file); });
}
