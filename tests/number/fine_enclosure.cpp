#include "catch.h"

#include "number/tracked.h"
#include "raylab/number/root.h"

using namespace raylab;
using namespace raylab::tracked;

namespace {

using Fine = Tracked<FineEnclosure>;

bool is_known(const FineEnclosure& x) { return std::isfinite(x.middle().high) && std::isfinite(x.radius()); }

bool holds(const Fine& x) {
    if (!is_known(x.enclosure)) return true;  // overflow guarantees nothing
    const mpq_class middle = mpq_class(x.enclosure.middle().high) + mpq_class(x.enclosure.middle().low);
    return abs(x.exact - middle) <= mpq_class(x.enclosure.radius());
}

bool rounded_holds(const Fine& x) {
    const Enclosure rounded = x.enclosure.rounded();
    if (!std::isfinite(rounded.middle()) || !std::isfinite(rounded.radius())) return true;
    return abs(x.exact - mpq_class(rounded.middle())) <= mpq_class(rounded.radius());
}

}  // namespace

TEST_CASE("a fine enclosure holds the exact value of what it was computed from, rounded to double too") {
    Leaves<FineEnclosure> draw;
    int wrong = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Fine x = expression(draw, draw.integer(1, 4));
        wrong += !holds(x) || !rounded_holds(x) || !sign_is_right(x);
    }
    CHECK(wrong == 0);
}

TEST_CASE("without under- and overflow a fine enclosure knows the sign of everything that is not zero") {
    const auto [unknown, zeros] = signless<FineEnclosure>(50'000);
    CHECK(unknown == 0);
    CHECK(zeros > 100);
}

TEST_CASE("what a fine enclosure does not round has no width") {
    const FineEnclosure third(1.0 / 3), tenth(0.1);
    CHECK((third * tenth).radius() == 0);
    CHECK((third + FineEnclosure(0x1p-80)).radius() == 0);
    CHECK((third * tenth * tenth).radius() > 0);
    CHECK(sign(third * tenth - tenth * third).value_or(Sign::positive) == Sign::zero);
}

TEST_CASE("overflow knows no sign in a fine enclosure either") {
    const FineEnclosure huge(0x1p1000), large(1e200);
    CHECK_FALSE(sign(huge * FineEnclosure(2)));
    CHECK_FALSE(sign(large * large));
    CHECK_FALSE(sign(large * large - large * large));
    CHECK_FALSE(sign(FineEnclosure(1e-320) * FineEnclosure(1e-10)));
}

TEST_CASE("a root of fine enclosures is good to a few units in the last place of a double, where doubles lose it") {
    // (t - 1)(t - (1 + 2^-30)): b^2 - a c = 2^-62
    const auto root = [](auto number) {
        using T = decltype(number);
        const T gap(0x1p-30), one(1.0), two(2.0);
        const T b = -(two + gap), c = one + gap;  // for t^2 + b t + c; the factor two keeps b an integer
        return Root<T>{two, b, two * c, b * b - two * (two * c), Sign::positive};
    };
    const Enclosure t = value(root(FineEnclosure()));
    CHECK(std::abs(t.middle() - (1 + 0x1p-30)) <= t.radius());
    CHECK(t.radius() < 0x1p-49);
    CHECK(value(root(Enclosure())).radius() > 0x1p-40);
}
