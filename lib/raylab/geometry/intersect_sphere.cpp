#include "raylab/geometry/meet_quadric.h"
#include "raylab/geometry/verdict.h"

#include <cmath>

namespace raylab {

namespace {

constexpr double u64 = unit_roundoff<double>;

enum class Where { before, inside, after, unknown };

Where where(double t, double error, const Interval<float>& range) {
    if (t + error < range.min) return Where::before;
    if (t - error > range.max) return Where::after;
    return t - error > range.min && t + error < range.max ? Where::inside : Where::unknown;
}

// A root with a bound of its error.
struct Approximate {
    double t, error;
};

// A verdict that fits registers.
struct Decided {
    enum class What { undecided, missed, hit } what;
    Approximate at = {};
};

inline Decided accept(const Approximate& hit) {
    return is_accurate(hit.t, hit.error) ? Decided{Decided::What::hit, hit} : Decided{Decided::What::undecided};
}

// The first of two roots inside the range, the ray going in at the one and out at the other.
template <class Entry, class Exit>
Decided first_of(const Entry& find_entry, const Exit& find_exit, const Interval<float>& range, Sides sides) {
    const Approximate entry = find_entry();
    const Where at_entry = where(entry.t, entry.error, range);
    if (at_entry == Where::inside && sees(sides, Sign::negative)) return accept(entry);
    if (at_entry == Where::after) return {Decided::What::missed};
    if (at_entry == Where::unknown) return {Decided::What::undecided};
    const Approximate exit = find_exit();
    const Where at_exit = where(exit.t, exit.error, range);
    if (at_exit == Where::unknown) return {Decided::What::undecided};
    return at_exit == Where::inside && sees(sides, Sign::positive) ? accept(exit) : Decided{Decided::What::missed};
}

// F(t) = a t^2 + 2 b t + c in plain doubles and bounds on what rounding did to it. Each coordinate of f carries one
// rounding; r r and the squares of d are exact (48 bits). Counting roundings per monomial, one unit to spare in each for
// the bounds' own rounding:
//   a: 2 (sums)                                      b: f 1, product 1, sums 2: 4 u |f|.|d|, at most 4 u sqrt(a f.f)
//   c: f 2, product 1, sums 2: 5 u f.f, and one more relative to c
//   discriminant: a r^2: 2 + 2; |d x f|^2: each coordinate of d x f errs by 3 u s, s = |d_i f_j| + |d_j f_i|, its square
//   by 7 u s^2 with its own rounding, the sum by 9, the difference by 10; s.s is at most 2 a f.f (Cauchy)
// Products of four floats stay between 2^-596 and 2^519: nothing under- or overflows.
Decided decide(const Ray& ray, const Sphere& sphere, Sides sides) {
    const Vec3d d = convert<double>(ray.direction);
    const Vec3d f = convert<double>(ray.origin) - convert<double>(sphere.center);
    const double squared_radius = double{sphere.radius} * sphere.radius;
    const double a = dot(d, d), b = dot(d, f), distance = dot(f, f), c = distance - squared_radius;
    const double c_error = 6 * u64 * distance + 2 * u64 * std::abs(c);
    // Outside and on the way out: both roots have the sign of -b.
    const bool outward = b > 0 && b * b > 26 * u64 * u64 * a * distance;
    if (outward && c > c_error && ray.range.min >= 0) return {Decided::What::missed};

    const Vec3d moment = cross(d, f);
    const double discriminant = a * squared_radius - dot(moment, moment);
    const double discriminant_error = 12 * u64 * a * (squared_radius + 2 * distance);
    if (discriminant < -discriminant_error) return {Decided::What::missed};
    if (!(discriminant > discriminant_error)) return {Decided::What::undecided};

    // The stable roots: t = q / a and t = c / q with q = -(b + sign(b) sqrt(discriminant)). The square root errs by less
    // than its argument's error over itself; of which b's is less than a sixth, since the root is at most sqrt(a) r and
    // (r^2 + 2 f.f) / r at least 2.8 |f|.
    const double surd = std::sqrt(discriminant);
    const double q = b > 0 ? -b - surd : surd - b;
    const double inverse = 1 / (std::abs(q) * surd);
    const double q_error = 1.25 * discriminant_error * inverse + 5 * u64;  // relative
    // A t cannot be better than q; and below this, dividing by q instead of its worst case adds less than 2^-25 of it.
    if (!(q_error < t_accuracy)) return {Decided::What::undecided};
    const auto by_a = [&]() -> Approximate {
        const double t = q / a;
        return {t, std::abs(t) * (q_error + 5 * u64)};
    };
    const auto by_q = [&]() -> Approximate {
        const double t = c / q;
        return {t, (std::abs(t) * (q_error + 5 * u64) + c_error * surd * inverse) * (1 + 2 * t_accuracy)};
    };
    return b > 0 ? first_of(by_a, by_q, ray.range, sides) : first_of(by_q, by_a, ray.range, sides);
}

template <Scalar T>
FilterVerdict decide_in(const Ray& ray, const Sphere& sphere, Sides sides) {
    Signs<T> signs;
    const auto found = meet(local_ray<T>(ray, {}), sphere, sides, signs);
    if (signs.undecided()) return Undecided{};
    if (!found) return Miss{};
    const Enclosure t = value(found->t);
    return Candidate{t.middle(), t.radius()};
}

}  // namespace

std::optional<Candidate> intersect(const Ray& ray, const Sphere& sphere, Decisions& decisions, Sides sides) {
    const Decided decided = decide(ray, sphere, sides);
    if (decided.what == Decided::What::missed) return std::nullopt;
    if (decided.what == Decided::What::hit) return Candidate{decided.at.t, decided.at.error};
    return settle([&]<Scalar T>() { return decide_in<T>(ray, sphere, sides); }, decisions);
}

}  // namespace raylab
