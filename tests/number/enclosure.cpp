#include "catch.h"

#include "number/tracked.h"
#include "raylab/number/enclosure.h"

#include <cmath>

using namespace raylab;
using namespace raylab::tracked;

namespace {

bool is_known(const Enclosure& x) { return std::isfinite(x.middle()) && std::isfinite(x.radius()); }

bool holds(const Tracked<Enclosure>& x) {
    if (!is_known(x.enclosure)) return true;  // overflow guarantees nothing
    return abs(x.exact - mpq_class(x.enclosure.middle())) <= mpq_class(x.enclosure.radius());
}

bool ends_are_outside(const Tracked<Enclosure>& x) {
    const double low = x.enclosure.lower(), high = x.enclosure.upper();
    if (!std::isfinite(low) || !std::isfinite(high)) return true;
    return mpq_class(low) <= x.exact && x.exact <= mpq_class(high);
}

}  // namespace

TEST_CASE("an enclosure holds the exact value of what it was computed from, and its ends lie outside") {
    Leaves<Enclosure> draw;
    int wrong = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Tracked<Enclosure> x = expression(draw, draw.integer(1, 4));
        wrong += !holds(x) || !ends_are_outside(x) || !sign_is_right(x);
    }
    CHECK(wrong == 0);
}

TEST_CASE("an enclosure's square root holds the exact root") {
    Leaves<Enclosure> draw;
    int wrong = 0;
    for (int i = 0; i < 50'000; ++i) {
        Tracked<Enclosure> x = expression(draw, draw.integer(0, 2));
        if (sgn(x.exact) < 0) x = combined(2, x, x);
        const Enclosure root = sqrt(x.enclosure);
        if (!is_known(root)) continue;
        // low <= sqrt(x) <= high, squared
        const mpq_class low(root.lower()), high(root.upper());
        wrong += (sgn(low) > 0 && low * low > x.exact) || sgn(high) < 0 || high * high < x.exact;
    }
    CHECK(wrong == 0);
}

TEST_CASE("without under- and overflow an enclosure knows the sign of nearly everything that is not zero") {
    const auto [unknown, zeros] = signless<Enclosure>(50'000);
    CHECK(unknown < 50);  // of 50 000: those near complete cancellation
    CHECK(zeros > 100);
}

TEST_CASE("what is not rounded is enclosed without width") {
    CHECK((Enclosure(3.5) + Enclosure(0.25)).radius() == 0);
    CHECK((Enclosure(3.5) - Enclosure(3.5)).radius() == 0);
    CHECK((Enclosure(0) * Enclosure(0.1)).radius() == 0);
    CHECK((Enclosure(1) + Enclosure(0x1p-60)).radius() > 0);
    CHECK(sign(Enclosure(3.5) - Enclosure(3.5)) == Sign::zero);
}

TEST_CASE("overflow, division by what may be zero and NaN know no sign") {
    const Enclosure huge(1e300);
    CHECK_FALSE(sign(huge * huge));
    CHECK_FALSE(sign(huge * huge - huge * huge));
    CHECK_FALSE(sign(Enclosure(1) / Enclosure(0)));
    CHECK_FALSE(sign(Enclosure(1) / Enclosure(0.5, 1)));
    CHECK_FALSE(sign(Enclosure(0.5, 1)));
}
