#include "raylab/number/estimate.h"

#include "catch.h"
#include "number/tracked.h"

using namespace raylab;
using namespace raylab::tracked;

namespace {

bool holds(const Tracked<Estimate>& x) {
    const Enclosure enclosed = x.enclosure.enclosed();
    // Overflow guarantees nothing.
    if (!std::isfinite(enclosed.middle()) || !std::isfinite(enclosed.radius())) return true;
    return abs(x.exact - mpq_class(enclosed.middle())) <= mpq_class(enclosed.radius());
}

}  // namespace

TEST_CASE("an estimate encloses the exact value of what it was computed from, where it under- or overflowed too") {
    Leaves<Estimate> draw;
    int wrong = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Tracked<Estimate> x = expression(draw, draw.integer(1, 4));
        wrong += !holds(x) || !sign_is_right(x);
    }
    CHECK(wrong == 0);
}

TEST_CASE("an estimate knows the sign of nearly everything that is not zero, and of nothing that is") {
    const auto [unknown, zeros] = signless<Estimate>(50'000);
    CHECK(unknown < 50);
    CHECK(zeros > 100);
    CHECK_FALSE(sign(Estimate(3.5) - Estimate(3.5)));
    CHECK_FALSE(sign(Estimate(0)));
}

TEST_CASE("what underflows has no sign, and neither has what overflows") {
    const Estimate tiny(1e-200), huge(1e200);
    CHECK_FALSE(sign(tiny * tiny));
    CHECK_FALSE(sign(tiny * tiny * huge * huge));
    CHECK_FALSE(sign(huge * huge));
    CHECK_FALSE(sign(huge * huge - huge * huge));
}
