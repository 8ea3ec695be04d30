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

// F(t) = a t^2 + 2 b t + c in plain doubles and bounds on what rounding did to it. Each coordinate of f carries one
// rounding; r r and the squares of d are exact (48 bits). Counting roundings per monomial, one unit to spare in each for
// the bounds' own rounding:
//   a: 2 (sums)                                      b: f 1, product 1, sums 2: 4 u |f|.|d|
//   c: f 2, product 1, sums 2: 5 u f.f, and one more relative to c
//   discriminant: a r^2: 2 + 2; |d x f|^2: each coordinate of d x f errs by 3 u s, s = |d_i f_j| + |d_j f_i|, its square
//   by 7 u s^2 with its own rounding, the sum by 9, the difference by 10
// Products of four floats stay between 2^-596 and 2^519: nothing under- or overflows.
struct Filter {
    double a, b, c, discriminant;
    double b_error, c_error, discriminant_error;
};

// (glm's abs of a vector calls through a pointer.)
Vec3d magnitude(const Vec3d& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

Filter filter(const Ray& ray, const Sphere& sphere) {
    const Vec3d d = convert<double>(ray.direction);
    const Vec3d f = convert<double>(ray.origin) - convert<double>(sphere.center);
    const double r = sphere.radius;
    const Vec3d moment = cross(d, f);
    const Vec3d p = magnitude(d), q = magnitude(f);
    const Vec3d s{p.y * q.z + p.z * q.y, p.z * q.x + p.x * q.z, p.x * q.y + p.y * q.x};
    const double a = dot(d, d);
    const double distance = dot(f, f);
    const double c = distance - r * r;
    return {a, dot(d, f), c, a * (r * r) - dot(moment, moment), 5 * u64 * dot(p, q),
            6 * u64 * distance + 2 * u64 * std::abs(c), 12 * u64 * (a * (r * r) + dot(s, s))};
}

// A root with a bound of its error.
struct Approximate {
    double t, error;
};

FilterVerdict accept(const Approximate& hit) {
    if (!is_accurate(hit.t, hit.error)) return Undecided{};
    return Candidate{hit.t, hit.error};
}

// The first of two roots inside the range, the ray going in at the one and out at the other.
FilterVerdict first_of(const Approximate& entry, const Approximate& exit, const Interval<float>& range, Sides sides) {
    const Where at_entry = where(entry.t, entry.error, range);
    if (at_entry == Where::after) return Miss{};
    if (at_entry == Where::unknown) return Undecided{};
    if (at_entry == Where::inside && sees(sides, Sign::negative)) return accept(entry);
    const Where at_exit = where(exit.t, exit.error, range);
    if (at_exit == Where::unknown) return Undecided{};
    return at_exit == Where::inside && sees(sides, Sign::positive) ? accept(exit) : FilterVerdict(Miss{});
}

FilterVerdict decide(const Filter& f, const Interval<float>& range, Sides sides) {
    if (f.discriminant < -f.discriminant_error) return Miss{};
    // Outside and on the way out: both roots have the sign of -b.
    if (f.b > f.b_error && f.c > f.c_error && range.min >= 0) return Miss{};
    if (!(f.discriminant > f.discriminant_error)) return Undecided{};

    // The stable roots: t = q / a and t = c / q with q = -(b + sign(b) sqrt(discriminant)). The square root errs by less
    // than its argument's error over itself.
    const double surd = std::sqrt(f.discriminant);
    const double q = f.b > 0 ? -f.b - surd : surd - f.b;
    const double inverse = 1 / std::abs(q);
    const double q_error = (f.b_error + f.discriminant_error / surd) * inverse + 5 * u64;  // relative
    // A t cannot be better than q; and below this, dividing by q instead of its worst case adds less than 2^-25 of it.
    if (!(q_error < t_accuracy)) return Undecided{};
    const double by_a = q / f.a, by_q = f.c / q;
    const Approximate large{by_a, std::abs(by_a) * (q_error + 5 * u64)};
    const Approximate small{by_q, (std::abs(by_q) * (q_error + 5 * u64) + f.c_error * inverse) * (1 + 2 * t_accuracy)};
    return f.b > 0 ? first_of(large, small, range, sides) : first_of(small, large, range, sides);
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
    const FilterVerdict verdict = decide(filter(ray, sphere), ray.range, sides);
    if (!std::holds_alternative<Undecided>(verdict)) return candidate_of(verdict);
    return settle([&]<Scalar T>() { return decide_in<T>(ray, sphere, sides); }, decisions);
}

}  // namespace raylab
