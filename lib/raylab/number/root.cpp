#include "raylab/number/root.h"

#include <cmath>
#include <limits>

namespace raylab {

namespace {

// The sign of p + q sqrt(d), where d is not negative: the term with the larger square decides.
Sign sign_of_sum(const Dyadic& p, const Dyadic& q, const Dyadic& d) {
    const Sign of_p = sign(p);
    const Sign of_surd = sign(q) * sign(d);
    if (of_p == of_surd || of_surd == Sign::zero) return of_p;
    if (of_p == Sign::zero) return of_surd;
    return of_p * sign(p * p - q * q * d);
}

// The sign of p + q sqrt(d) + r sqrt(e): squaring against its last term reduces it to a sum of the kind above.
Sign sign_of_sum(const Dyadic& p, const Dyadic& q, const Dyadic& d, const Dyadic& r, const Dyadic& e) {
    const Sign of_first = sign_of_sum(p, q, d);
    const Sign of_last = sign(r) * sign(e);
    if (of_first == of_last || of_last == Sign::zero) return of_first;
    if (of_first == Sign::zero) return of_last;
    return of_first * sign_of_sum(p * p + q * q * d - r * r * e, (p + p) * q, d);
}

Dyadic times(Sign sign, const Dyadic& x) { return Dyadic(static_cast<int>(sign)) * x; }

}  // namespace

Sign compare(const Root<Dyadic>& t, const Root<Dyadic>& s) {
    // t - s over the common denominator a_t a_s
    return sign(t.a) * sign(s.a) *
           sign_of_sum(t.a * s.b - s.a * t.b, times(t.branch, s.a), t.discriminant, times(-s.branch, t.a),
                       s.discriminant);
}

Enclosure value(const Root<Enclosure>& root) {
    if (root.branch == Sign::zero) return -root.b / root.a;
    const Enclosure surd = sqrt(root.discriminant);
    const bool plus = root.branch == Sign::positive;
    // One of the two forms of a root has cancellation: Press et al., Numerical Recipes, section 5.6.
    const bool cancels = (root.b.middle() > 0) == plus;
    if (cancels) return root.c / (plus ? -root.b - surd : surd - root.b);
    return (plus ? surd - root.b : -root.b - surd) / root.a;
}

Enclosure value(const Root<Estimate>& root) {
    return value(Root<Enclosure>{root.a.enclosed(), root.b.enclosed(), root.c.enclosed(), root.discriminant.enclosed(),
                                 root.branch});
}

Enclosure value(const Root<FineEnclosure>& root) {
    // Cancellation has already happened in a, b and c: the stable form of a root only multiplies and divides, for which
    // doubles suffice.
    return value(Root<Enclosure>{root.a.rounded(), root.b.rounded(), root.c.rounded(), root.discriminant.rounded(),
                                 root.branch});
}

Enclosure value(const Root<Dyadic>& root) {
    const Dyadic surd = times(root.branch, sqrt(root.discriminant));
    const bool cancels = root.branch != Sign::zero && sign(root.b) == root.branch;
    const double t = cancels ? quotient(root.c, -root.b - surd) : quotient(surd - root.b, root.a);
    // The square root has 120 correct bits and the quotient is rounded once: the error is u + 2^-118 of t, and the
    // bound is 4 u.
    return {t, 4 * unit_roundoff<double> * std::abs(t) + std::numeric_limits<double>::denorm_min()};
}

}  // namespace raylab
