#include "catch.h"

#include "raylab/experiment/adversarial/adversarial.h"
#include "raylab/number/dyadic.h"

#include <cmath>
#include <limits>

using namespace raylab;

namespace {

class Numbers : public adversarial::Draw {
public:
    Numbers() : Draw(2) {}
    double next() {
        if (integer(0, 9) == 0) return integer(-2, 2);
        return std::ldexp(number(0, 1) - 0.5, integer(-1070, 1000));
    }
};

// Nearest by definition: no double beside it is nearer.
bool is_nearest(double given, const mpq_class& exact) {
    const mpq_class error = abs(mpq_class(given) - exact);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double neighbour : {std::nextafter(given, infinity), std::nextafter(given, -infinity)}) {
        if (std::isfinite(neighbour) && abs(mpq_class(neighbour) - exact) < error) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("dyadic sums, differences, products and signs are those of rationals") {
    Numbers draw;
    int wrong = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double a = draw.next(), b = draw.next(), c = draw.next();
        const Dyadic x = (Dyadic(a) + Dyadic(b)) * Dyadic(c) - Dyadic(b);
        const mpq_class y = (mpq_class(a) + mpq_class(b)) * mpq_class(c) - mpq_class(b);
        wrong += x.rational() != y || static_cast<int>(sign(x)) != sgn(y) || (-x).rational() != -y;
    }
    CHECK(wrong == 0);
}

TEST_CASE("the quotient of two dyadics is the nearest double") {
    Numbers draw;
    int wrong = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double a = draw.next(), b = draw.next(), c = draw.next();
        const Dyadic n = Dyadic(a) * Dyadic(c) + Dyadic(b), d = Dyadic(b) - Dyadic(c);
        if (sign(d) == Sign::zero) continue;
        const double given = quotient(n, d);
        if (!std::isnormal(given)) continue;
        wrong += !is_nearest(given, n.rational() / d.rational());
    }
    CHECK(wrong == 0);
    CHECK(quotient(Dyadic(1), Dyadic(3)) == 1.0 / 3.0);
    CHECK(quotient(Dyadic(0), Dyadic(3)) == 0);
    CHECK(quotient(Dyadic(-1e300) * Dyadic(1e300), Dyadic(1e-300)) == -std::numeric_limits<double>::infinity());
}

TEST_CASE("the square root of a dyadic is right to 120 bits, from below") {
    Numbers draw;
    int wrong = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Dyadic x = Dyadic(std::abs(draw.next())) + Dyadic(std::abs(draw.next()));
        const mpq_class root = sqrt(x).rational(), above = root * (1 + mpq_class(1, mpz_class(1) << 119));
        wrong += root * root > x.rational() || (sign(x) != Sign::zero && above * above <= x.rational());
    }
    CHECK(wrong == 0);
    CHECK(sqrt(Dyadic(0.25)).rational() == mpq_class(1, 2));
}
