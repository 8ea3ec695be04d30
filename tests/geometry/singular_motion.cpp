#include "catch.h"

#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/geometry/singular_motion.h"

#include <cmath>
#include <limits>

using namespace raylab;

namespace {

// The placement stretches x by begin + rate t.
bool is_singular_stretch(float begin, float rate, const Interval<float>& times) {
    Affine placement;
    placement.columns[0].x = begin;
    Motion motion;
    motion.columns[0].x = rate;
    return is_singular_during(placement, motion, times);
}

}  // namespace

TEST_CASE("a stretch that passes through zero is singular then, to the last float") {
    CHECK(is_singular_stretch(1, -2, {0, 1}));
    CHECK(is_singular_stretch(1, -2, {0, 0.5f}));
    CHECK(is_singular_stretch(1, -2, {0.5f, 1}));
    CHECK_FALSE(is_singular_stretch(1, -2, {0, std::nextafter(0.5f, 0.0f)}));
    CHECK_FALSE(is_singular_stretch(1, -2, {std::nextafter(0.5f, 1.0f), 1}));
    CHECK_FALSE(is_singular_stretch(1, 0, {-1, 1}));
    CHECK(is_singular_stretch(0, 0, {0, 0}));
}

TEST_CASE("a determinant that touches zero and turns back is singular there") {
    // Both x and y are stretched by 1 - 3 t: zero twice at a third, which no float is.
    Motion motion;
    motion.columns[0].x = motion.columns[1].y = -3;
    CHECK(is_singular_during({}, motion, {0, 1}));
    CHECK_FALSE(is_singular_during({}, motion, {0, 0x1.555554p-2f}));
    CHECK_FALSE(is_singular_during({}, motion, {0x1.555556p-2f, 1}));
    motion.columns[2].z = -3;  // three times
    CHECK(is_singular_during({}, motion, {0, 1}));
}

TEST_CASE("a half turn with linear entries collapses, and a quarter turn does not") {
    const Affine half_turn{{Vec3f{-1, 0, 0}, Vec3f{0, -1, 0}, Vec3f{0, 0, 1}}};
    const Affine quarter_turn{{Vec3f{0, 1, 0}, Vec3f{-1, 0, 0}, Vec3f{0, 0, 1}}};
    const auto toward = [](const Affine& end) {
        Motion motion;
        for (std::size_t i = 0; i < 3; ++i) motion.columns[i] = end.columns[i] - Affine{}.columns[i];
        return motion;
    };
    CHECK(is_singular_during({}, toward(half_turn), {0, 1}));
    CHECK_FALSE(is_singular_during({}, toward(quarter_turn), {0, 1}));
}

TEST_CASE("sums that cancel beyond doubles are seen") {
    const float small = 0x1p-20f;
    Motion motion;
    motion.columns[0] = {-1, small, 0};
    Affine placement;
    placement.columns[1] = {small, 1, 0};
    // (1 - t) 1 - (t small) small = 1 - t (1 + 2^-40): zero a little before t = 1
    CHECK(is_singular_during(placement, motion, {0, 1}));
    CHECK_FALSE(is_singular_during(placement, motion, {0, std::nextafter(1.0f, 0.0f)}));
    CHECK_FALSE(is_singular_during(placement, motion, {1, 2}));
}

TEST_CASE("any motion is singular between two times where the determinant's sign differs, and where a moment is") {
    adversarial::Draw draw(1);
    int singular = 0;
    for (int i = 0; i < 3'000; ++i) {
        const Affine placement = adversarial::any_placement(draw);
        const Motion motion = adversarial::any_motion(draw);
        const bool found = is_singular_during(placement, motion, {0, 1});
        bool at_a_moment = false;
        for (int k = 0; k <= 16; ++k)
            at_a_moment = at_a_moment || adversarial::is_singular_at(placement, motion, cast<float>(k) / 16);
        singular += found;
        CHECK((found || !at_a_moment));
        CHECK((found || is_singular_during(placement, motion, {0, 0.5f}) == false));
    }
    CHECK(singular > 100);
    CHECK(singular < 2'900);
}
