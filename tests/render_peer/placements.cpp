#include "alike.h"
#include "catch.h"
#include "contact_sheet.h"

// Compares fronts and backs of placed shapes, lit and in shadow, from two sides.

using namespace raylab;

namespace {

// A triangle that shows its other side fills some windows.
constexpr SamePicture alike_in_windows{
    .outlier_share = 0.0005, .tile = 4, .tile_share = 0.6, .mean = {.absolute = 1e-4, .relative = 1e-3}};

// For POV-Ray a ray through a surface that is visible from its other side only is one level deeper.
constexpr int depth = 20;

void check_both_ways(const Scene& scene) {
    check_alike(scene, depth, alike_in_windows);
    check_alike(from_behind(scene), depth, alike_in_windows);
}

}  // namespace

TEST_CASE("POV-Ray sees front and back of every shape as we do, however it is placed") {
    const auto seed = GENERATE(1u, 2u);
    INFO("seed " << seed);
    check_both_ways(contact_sheet(seed));
}

TEST_CASE("POV-Ray sees front and back of placed planes as we do") { check_both_ways(room_of_planes(1)); }
