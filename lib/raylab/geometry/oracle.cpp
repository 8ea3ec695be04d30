#include "raylab/geometry/oracle_numbers.h"

#include <cassert>
#include <cmath>
#include <iterator>

namespace raylab::oracle {

Rational exact(double value) {
    assert(std::isfinite(value));
    return Rational(value);
}

Exact::Point_3 exact_point(const Vec3d& point) { return {exact(point.x), exact(point.y), exact(point.z)}; }
Exact::Vector_3 exact_vector(const Vec3d& vector) { return {exact(vector.x), exact(vector.y), exact(vector.z)}; }

Line exact_line(const RayOf<double>& ray) {
    assert(ray.direction != Vec3d(0));
    return {exact_point(ray.origin), exact_vector(ray.direction)};
}

Answer answer(const Contacts& contacts, const Interval<double>& range) {
    const Contact* nearest = nullptr;
    const Contact* first = nullptr;  // on the whole line
    for (const Contact& hit : contacts.hits) {
        if (!first || hit.t < first->t) first = &hit;
        if (compare(hit.t, range.min) < 0 || compare(hit.t, range.max) > 0) continue;
        if (!nearest || hit.t < nearest->t) nearest = &hit;
    }
    if (nearest) return {nearest->meeting, ExactT(std::make_shared<const ExactT::Value>(nearest->t))};
    if (first) return {first->meeting, std::nullopt};
    return {contacts.within ? Meeting::within : Meeting::miss, std::nullopt};
}

InT square(const InT& linear) {
    assert(linear.c2 == 0);
    return {linear.c0 * linear.c0, 2 * linear.c0 * linear.c1, linear.c1 * linear.c1};
}

namespace {

/// The square root of x if it is rational.
std::optional<Rational> rational_root(const Rational& x) {
    const auto root_of = [](const CGAL::Gmpz& n) {
        CGAL::Gmpz root;
        mpz_sqrt(root.mpz(), n.mpz());
        return root;
    };
    const CGAL::Gmpz numerator = x.numerator(), denominator = x.denominator();
    if (!mpz_perfect_square_p(numerator.mpz()) || !mpz_perfect_square_p(denominator.mpz())) return {};
    return Rational(root_of(numerator), root_of(denominator));
}

/// The same number, as a rational if it is one.
Root simplified(const Root& x) {
    if (!x.is_extended()) return x;
    const auto root = rational_root(x.root());
    return root ? Root(x.a0() + x.a1() * *root) : x;
}

}  // namespace

Zeros zeros(const InT& equation) {
    if (equation.c2 == 0 && equation.c1 == 0) return {equation.c0 == 0, {}, false};
    std::vector<Root> roots;
    CGAL::compute_roots_of_2(equation.c2, equation.c1, equation.c0, std::back_inserter(roots));
    for (Root& root : roots) root = simplified(root);
    const bool twice = equation.c2 != 0 && roots.size() == 1;
    return {false, std::move(roots), twice};
}

}  // namespace raylab::oracle
