#include "catch.h"

#include "raylab/image/picture_files/files.h"

#include "hostile/refusals.h"

TEST_CASE("each broken picture is refused, on one line that says what was expected and what was found") {
    check_refusals(RAYLAB_SOURCE "/tests/hostile/pictures", [](const auto& file) { raylab::read_image(file); });
}
