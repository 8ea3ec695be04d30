#include "raylab/geometry/singular_motion.h"

#include <gmpxx.h>

#include <cstddef>
#include <vector>

namespace raylab {

namespace {

using Polynomial = std::vector<mpq_class>;  // the coefficient of t^i at i; the last one is not zero

mpq_class volume(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const auto exact = [](const Vec3f& v) { return Triple<mpq_class>{v.x, v.y, v.z}; };
    return dot(exact(a), cross(exact(b), exact(c)));
}

Polynomial trimmed(Polynomial p) {
    while (!p.empty() && sgn(p.back()) == 0) p.pop_back();
    return p;
}

// det (M + t R) is linear in each column: a cubic.
Polynomial determinant(const Affine& placement, const Motion& motion) {
    const auto& [a, b, c] = placement.columns;
    const auto& [x, y, z] = motion.columns;
    return trimmed({volume(a, b, c), volume(x, b, c) + volume(a, y, c) + volume(a, b, z),
                    volume(a, y, z) + volume(x, b, z) + volume(x, y, c), volume(x, y, z)});
}

int sign_at(const Polynomial& p, const mpq_class& t) {
    mpq_class sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * t + p[i];
    return sgn(sum);
}

Polynomial derivative(const Polynomial& p) {
    Polynomial result;
    for (std::size_t i = 1; i < p.size(); ++i) result.push_back(p[i] * static_cast<unsigned long>(i));
    return result;
}

// Of the division of p by q, the negative.
Polynomial negative_remainder(Polynomial p, const Polynomial& q) {
    while (p.size() >= q.size()) {
        const mpq_class factor = p.back() / q.back();
        for (std::size_t i = 1; i <= q.size(); ++i) p[p.size() - i] -= factor * q[q.size() - i];
        p = trimmed(p);
    }
    for (mpq_class& coefficient : p) coefficient = -coefficient;
    return p;
}

// How often the signs of Sturm's sequence change at t.
int sign_changes(const std::vector<Polynomial>& sequence, const mpq_class& t) {
    int changes = 0, last = 0;
    for (const Polynomial& p : sequence) {
        const int now = sign_at(p, t);
        if (now != 0 && last != 0 && now != last) ++changes;
        if (now != 0) last = now;
    }
    return changes;
}

// Sturm's theorem: between two places that are no zeros there are as many different zeros as sign changes get lost.
// (Basu, Pollack & Roy, Algorithms in Real Algebraic Geometry, section 2.2.2.)
bool has_zero_between(const Polynomial& p, const mpq_class& begin, const mpq_class& end) {
    std::vector<Polynomial> sequence{p, derivative(p)};
    while (!sequence.back().empty())
        sequence.push_back(negative_remainder(sequence[sequence.size() - 2], sequence.back()));
    return sign_changes(sequence, begin) != sign_changes(sequence, end);
}

}  // namespace

bool is_singular_during(const Affine& placement, const Motion& motion, const Interval<float>& times) {
    const Polynomial p = determinant(placement, motion);
    const mpq_class begin = times.min, end = times.max;
    return sign_at(p, begin) == 0 || sign_at(p, end) == 0 || has_zero_between(p, begin, end);
}

}  // namespace raylab
