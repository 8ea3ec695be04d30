#include "catch.h"

#include "raylab/number/root.h"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

using namespace raylab;

namespace {

// Roots whose values are known: of (t - p)(t - q), or p +- sqrt(n), with small integers.
struct Known {
    Root<Dyadic> root;
    long rational;  // the value is rational + branch sqrt(radicand)
    long radicand;
    int branch;
};

Known surd(long scale, long p, long n, int branch) {
    // scale (t^2 - 2 p t + p^2 - n); the branch is that of sqrt(discriminant) / scale
    const auto number = [](long x) { return Dyadic(static_cast<double>(x)); };
    const auto sign = static_cast<Sign>(scale < 0 ? -branch : branch);
    return {{number(scale), number(-scale * p), number(scale * (p * p - n)), number(scale * scale * n), sign},
            p,
            n,
            branch};
}

Known fraction(long scale, long p) {
    return {ratio(Dyadic(static_cast<double>(scale * p)), Dyadic(static_cast<double>(scale))), p, 0, 0};
}

// Far more bits than square roots of small integers need to differ.
mpf_class digits(const Known& known) {
    mpf_class root(0, 2000);
    root = sqrt(mpf_class(known.radicand, 2000));
    return mpf_class(known.rational + known.branch * root, 2000);
}

int sign_of(const mpf_class& x) {
    const mpf_class tiny = mpf_class(1, 2000) >> 1000;
    return abs(x) < tiny ? 0 : sgn(x);
}

std::vector<Known> roots() {
    std::vector<Known> result;
    for (const long scale : {1L, -3L}) {
        for (long p = -3; p <= 3; ++p) {
            result.push_back(fraction(scale, p));
            for (const long n : {0L, 1L, 2L, 4L, 7L, 8L}) {
                for (const int branch : {-1, 1}) result.push_back(surd(scale, p, n, branch));
            }
        }
    }
    return result;
}

}  // namespace

TEST_CASE("two roots compare as their digits do") {
    int wrong = 0;
    const auto all = roots();
    for (const Known& a : all) {
        for (const Known& b : all) wrong += static_cast<int>(compare(a.root, b.root)) != sign_of(digits(a) - digits(b));
    }
    CHECK(wrong == 0);
}

TEST_CASE("the sign of a linear function at a root is that of its digits") {
    int wrong = 0;
    for (const Known& a : roots()) {
        for (long p = -6; p <= 6; ++p) {
            for (long q = -2; q <= 2; ++q) {
                Signs<Dyadic> signs;
                const Sign given =
                    sign_at(a.root, Dyadic(static_cast<double>(p)), Dyadic(static_cast<double>(q)), signs);
                const mpf_class truth = p + q * digits(a);
                wrong += static_cast<int>(given) != sign_of(truth);
            }
        }
    }
    CHECK(wrong == 0);
}

TEST_CASE("enclosures of coefficients give the exact signs or none, and enclose the root") {
    const auto enclosed = [](const Dyadic& x) { return Enclosure(quotient(x, Dyadic(1))); };
    int wrong = 0, decided = 0;
    for (const Known& a : roots()) {
        const Root<Enclosure> root{enclosed(a.root.a), enclosed(a.root.b), enclosed(a.root.c),
                                   enclosed(a.root.discriminant), a.root.branch};
        const Enclosure at = value(root), exactly = value(a.root);
        const double truth = digits(a).get_d();
        wrong +=
            !(at.lower() <= truth && truth <= at.upper()) || !(exactly.lower() <= truth && truth <= exactly.upper());
        for (long p = -6; p <= 6; ++p) {
            Signs<Enclosure> signs;
            const Sign given = compare(root, Enclosure(static_cast<double>(p)), signs);
            if (signs.undecided()) continue;
            ++decided;
            wrong += static_cast<int>(given) != sign_of(digits(a) - p);
        }
    }
    CHECK(wrong == 0);
    CHECK(decided > 1000);
}

TEST_CASE("a root keeps its digits where b and the square root cancel") {
    // x^2 - 2 x + 1e-8: the textbook formula loses half the digits of the smaller root
    const Root<Dyadic> root{Dyadic(1), Dyadic(-1), Dyadic(1e-8), Dyadic(1) - Dyadic(1e-8), Sign::negative};
    CHECK_THAT(value(root).middle(), WithinRel(5.000000012500000062e-9, 1e-15));
}
