#include "catch.h"

#include "raylab/report/structure/structure_replay.h"

#include "hostile/refusals.h"

TEST_CASE("each broken replay is refused, on one line that says what was expected and what was found") {
    check_refusals(RAYLAB_SOURCE "/tests/hostile/replays", [](const auto& file) { raylab::read_difference(file); });
}
