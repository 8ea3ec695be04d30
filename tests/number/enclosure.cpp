#include "catch.h"

#include "raylab/number/enclosure.h"

#include <gmpxx.h>

#include <cmath>
#include <random>

using namespace raylab;

namespace {

// A number and an enclosure that must hold it, however it was computed.
struct Tracked {
    mpq_class exact;
    Enclosure enclosure;
};

class Draw {
public:
    Draw() = default;
    explicit Draw(int exponent_limit) : lowest_(-exponent_limit), highest_(exponent_limit) {}

    // Any double a product of floats may be, subnormal ones and zero too; mostly near one, where cancellation lives.
    Tracked leaf() {
        if (integer(0, 9) == 0) return of(0);
        if (integer(0, 3) == 0) return of(integer(-4, 4));
        const double mantissa = std::generate_canonical<double, 53>(bits_) * (integer(0, 1) ? 2 : -2);
        return of(std::ldexp(mantissa, integer(0, 3) ? integer(-30, 30) : integer(lowest_, highest_)));
    }
    int integer(int low, int high) { return std::uniform_int_distribution(low, high)(bits_); }

private:
    static Tracked of(double x) { return {mpq_class(x), Enclosure(x)}; }
    std::mt19937_64 bits_{1};
    int lowest_ = -1074, highest_ = 300;
};

Tracked combined(int operation, const Tracked& a, const Tracked& b) {
    switch (operation) {
        case 0: return {a.exact + b.exact, a.enclosure + b.enclosure};
        case 1: return {a.exact - b.exact, a.enclosure - b.enclosure};
        case 2: return {-a.exact, -a.enclosure};
        case 3: return b.exact == 0 ? a : Tracked{a.exact / b.exact, a.enclosure / b.enclosure};
        default: return {a.exact * b.exact, a.enclosure * b.enclosure};
    }
}

Tracked expression(Draw& draw, int depth) {
    if (depth == 0) return draw.leaf();
    return combined(draw.integer(0, 7), expression(draw, depth - 1), expression(draw, depth - 1));
}

bool is_known(const Enclosure& x) { return std::isfinite(x.middle()) && std::isfinite(x.radius()); }

bool holds(const Tracked& x) {
    if (!is_known(x.enclosure)) return true;  // overflow promises nothing
    return abs(x.exact - mpq_class(x.enclosure.middle())) <= mpq_class(x.enclosure.radius());
}

bool ends_are_outside(const Tracked& x) {
    const double low = x.enclosure.lower(), high = x.enclosure.upper();
    if (!std::isfinite(low) || !std::isfinite(high)) return true;
    return mpq_class(low) <= x.exact && x.exact <= mpq_class(high);
}

bool sign_is_right(const Tracked& x) {
    const auto known = sign(x.enclosure);
    return !known || static_cast<int>(*known) == sgn(x.exact);
}

}  // namespace

TEST_CASE("an enclosure holds the exact value of what it was computed from, and its ends lie outside") {
    Draw draw;
    int wrong = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Tracked x = expression(draw, draw.integer(1, 4));
        wrong += !holds(x) || !ends_are_outside(x) || !sign_is_right(x);
    }
    CHECK(wrong == 0);
}

TEST_CASE("an enclosure's square root holds the exact root") {
    Draw draw;
    int wrong = 0;
    for (int i = 0; i < 50'000; ++i) {
        Tracked x = expression(draw, draw.integer(0, 2));
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
    Draw draw(100);
    int unknown = 0, zeros = 0;
    for (int i = 0; i < 50'000; ++i) {
        const Tracked x = expression(draw, 2);
        if (sgn(x.exact) == 0) ++zeros;
        else unknown += !sign(x.enclosure);
    }
    CHECK(unknown < 50);  // of 50 000: true near-cancellation
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
