#include "catch.h"

#include "raylab/report/ray_tree/ray_tree_json.h"

#include "hostile/refusals.h"

TEST_CASE("each broken ray tree is refused, on one line that says what was expected and what was found") {
    check_refusals(RAYLAB_SOURCE "/tests/hostile/ray_trees", [](const auto& file) { raylab::read_ray_tree(file); });
}
