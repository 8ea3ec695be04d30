#include "catch.h"

#include "raylab/experiment/adversarial/adversarial.h"
#include "raylab/number/double_double.h"

#include <gmpxx.h>

#include <cmath>

using namespace raylab;

namespace {

const mpq_class u2 = mpq_class(0x1p-106);

mpq_class exact(const DoubleDouble& x) { return mpq_class(x.high) + mpq_class(x.low); }

// Numbers that make rounding as bad as it gets: mantissas near both ends of a binade, low parts of all sizes, and
// partners that cancel.
class Pairs : public adversarial::Draw {
public:
    Pairs() : Draw(7) {}
    double single(int exponent_limit) {
        const double mantissa = one_in(3) ? 1 + 0x1p-52 * integer(-64, 64) : 1 + number(0, 1);
        return std::ldexp(one_in(2) ? mantissa : -mantissa, integer(-exponent_limit, exponent_limit));
    }
    DoubleDouble pair(int exponent_limit) {
        const double high = single(exponent_limit);
        const double low =
            one_in(4) ? 0 : high * 0x1p-53 * (one_in(3) ? 0.999 : std::ldexp(single(0) / 2, -integer(0, 20)));
        return two_sum(high, low);
    }
    DoubleDouble partner(const DoubleDouble& a) {
        if (!one_in(2)) return pair(3);
        return two_sum(-a.high * (1 + 0x1p-52 * integer(-2, 2)), one_in(2) ? -a.low : a.low / 3);
    }
};

bool is_normal(const DoubleDouble& x) { return x.high + x.low == x.high; }

}  // namespace

TEST_CASE("two_sum and two_product are exact, whatever the exponents") {
    Pairs draw;
    int wrong = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double a = draw.single(450), b = draw.one_in(2) ? draw.single(450) : a * draw.single(2);
        wrong += exact(two_sum(a, b)) != mpq_class(a) + mpq_class(b);
        wrong += exact(two_product(a, b)) != mpq_class(a) * mpq_class(b);
    }
    CHECK(wrong == 0);
}

TEST_CASE("a sum errs by 3 u^2, a product by 9 u^2 of itself, and both are rounded to their high part") {
    Pairs draw;
    mpq_class of_sums = 0, of_products = 0;
    int unnormal = 0;
    for (int i = 0; i < 200'000; ++i) {
        const DoubleDouble a = draw.pair(3), b = draw.partner(a);
        const mpq_class sum = exact(a) + exact(b), product = exact(a) * exact(b);
        const mpq_class sum_error = abs(exact(a + b) - sum), product_error = abs(exact(a * b) - product);
        if (sum == 0)
            CHECK(sum_error == 0);
        else
            of_sums = std::max(of_sums, mpq_class(sum_error / abs(sum) / u2));
        of_products = std::max(of_products, mpq_class(product_error / abs(product) / u2));
        unnormal += !is_normal(a + b) || !is_normal(a * b) || !is_normal(a - b);
    }
    CHECK(of_sums.get_d() < 3.0000000001);
    CHECK(of_products.get_d() < 9);
    CHECK(of_sums.get_d() > 1.5);  // the bounds are not idle
    CHECK(of_products.get_d() > 2);
    CHECK(unnormal == 0);
}

TEST_CASE("where both low parts are zero, sum and product are exact") {
    Pairs draw;
    int wrong = 0;
    for (int i = 0; i < 20'000; ++i) {
        const DoubleDouble a(draw.single(300)), b(draw.single(300));
        wrong += exact(a + b) != exact(a) + exact(b) || exact(a - b) != exact(a) - exact(b) ||
                 exact(a * b) != exact(a) * exact(b);
    }
    CHECK(wrong == 0);
}

TEST_CASE("a product that underflows errs by 8 of the smallest double more") {
    Pairs draw;
    const mpq_class smallest(0x1p-1074);
    mpq_class worst = 0;
    for (int i = 0; i < 50'000; ++i) {
        const DoubleDouble a = draw.pair(3), b = draw.pair(3);
        const double small = std::ldexp(1.0, -draw.integer(480, 540));
        const DoubleDouble p{a.high * small, a.low * small}, q{b.high * small, b.low * small};
        const mpq_class product = exact(p) * exact(q);
        const mpq_class error = abs(exact(p * q) - product) - 9 * u2 * abs(product);
        worst = std::max(worst, mpq_class(error / smallest));
    }
    CHECK(worst.get_d() < 8);
    CHECK(worst.get_d() > 0.4);
}

TEST_CASE("overflow leaves no finite number") {
    const DoubleDouble huge(0x1p1000), large(0x1p600);
    CHECK_FALSE(std::isfinite((large * large).high));
    CHECK_FALSE(std::isfinite((huge * DoubleDouble(1)).high));
    CHECK_FALSE(std::isfinite((DoubleDouble(0x1.8p1023) + DoubleDouble(0x1.8p1023)).high));
}
