#include "raylab/geometry/oracle/oracle_cgal.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <iterator>
#include <utility>

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

namespace {

bool is_seen(const Contact& contact, Sides sides) {
    if (sides == Sides::both) return true;
    return contact.along_normal != (sides == Sides::front ? CGAL::POSITIVE : CGAL::NEGATIVE);
}

}  // namespace

Answer answer(const Contacts& contacts, const Interval<double>& range, Sides sides) {
    const Contact* nearest = nullptr;
    const Contact* first = nullptr;  // on the whole line
    for (const Contact& hit : contacts.hits) {
        if (!first || hit.t < first->t) first = &hit;
        if (!is_seen(hit, sides)) continue;
        if (compare(hit.t, range.min) < 0 || compare(hit.t, range.max) > 0) continue;
        if (!nearest || hit.t < nearest->t) nearest = &hit;
    }
    if (nearest) return {nearest->hit_kind, ExactT(std::make_shared<const ExactT::Value>(nearest->t))};
    if (first) return {first->hit_kind, std::nullopt};
    return {contacts.within ? HitKind::within : HitKind::miss, std::nullopt};
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
    if (equation.c2 == 0 && equation.c1 == 0) return {equation.c0 == 0, {}};
    std::vector<Root> roots;
    CGAL::compute_roots_of_2(equation.c2, equation.c1, equation.c0, std::back_inserter(roots));
    Zeros zeros;
    for (const Root& root : roots) {
        const Root slope = 2 * equation.c2 * root + equation.c1;
        zeros.at.push_back({simplified(root), CGAL::sign(slope)});
    }
    return zeros;
}

namespace {

/// A placement in exact numbers.
struct ExactPlacement {
    std::array<Exact::Vector_3, 3> columns;
    Exact::Vector_3 translation;
};

ExactPlacement exact_placement(const std::array<Vec3f, 3>& columns, const Vec3f& translation) {
    const auto vector = [](const Vec3f& v) { return exact_vector(convert<double>(v)); };
    return {{vector(columns[0]), vector(columns[1]), vector(columns[2])}, vector(translation)};
}

/// The x with x.x columns[0] + x.y columns[1] + x.z columns[2] = right, by elimination.
Exact::Vector_3 solve(const std::array<Exact::Vector_3, 3>& columns, const Exact::Vector_3& right) {
    std::array<std::array<Rational, 4>, 3> rows;
    for (int row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) rows[row][column] = columns[column][row];
        rows[row][3] = right[row];
    }
    for (std::size_t pivot = 0; pivot < 3; ++pivot) {
        const auto usable = std::find_if(rows.begin() + pivot, rows.end(), [&](auto& row) { return row[pivot] != 0; });
        assert(usable != rows.end());  // readers refuse a singular transform
        std::swap(rows[pivot], *usable);
        for (std::size_t row = 0; row < 3; ++row) {
            if (row == pivot) continue;
            const Rational factor = rows[row][pivot] / rows[pivot][pivot];
            for (std::size_t column = pivot; column < 4; ++column) rows[row][column] -= factor * rows[pivot][column];
        }
    }
    return {rows[0][3] / rows[0][0], rows[1][3] / rows[1][1], rows[2][3] / rows[2][2]};
}

/// The same line with the same t, seen from where the shape was defined.
Line before(const ExactPlacement& placement, const Line& line) {
    return {CGAL::ORIGIN + solve(placement.columns, line.origin - CGAL::ORIGIN - placement.translation),
            solve(placement.columns, line.direction)};
}

Line before(const Affine& placement, const Line& line) {
    if (placement.is_identity()) return line;
    return before(exact_placement(placement.columns, placement.translation), line);
}

Contacts intersect_line(const Line& line, const Sphere& sphere) {
    return intersect_line(line, SphereOf<double>{convert<double>(sphere.center), sphere.radius});
}

Contacts intersect_line(const Line& line, const Triangle& triangle) {
    return intersect_line(line, TriangleOf<double>{convert<double>(triangle.a), convert<double>(triangle.b),
                                                   convert<double>(triangle.c)});
}

Contacts intersect_line(const Line& line, const std::shared_ptr<const Mesh>& mesh) {
    Contacts contacts;
    for (std::size_t face = 0; face < mesh->faces.size(); ++face) {
        const Contacts one = intersect_line(line, mesh->triangle(face));
        contacts.hits.insert(contacts.hits.end(), one.hits.begin(), one.hits.end());
        contacts.within = contacts.within || one.within;
    }
    return contacts;
}

}  // namespace

namespace {

Answer intersect_before(const Line& line, const Shape& shape, const Interval<double>& range, Sides sides) {
    return answer(std::visit([&](const auto& one) { return intersect_line(line, one); }, shape), range, sides);
}

}  // namespace

Answer intersect(const RayOf<double>& ray, const Shape& shape, const Affine& placement, Sides sides) {
    return intersect_before(before(placement, exact_line(ray)), shape, ray.range, sides);
}

Answer intersect(const RayOf<double>& ray, const Shape& shape, const Affine& placement, const Motion& motion,
                 float time, Sides sides) {
    ExactPlacement at = exact_placement(placement.columns, placement.translation);
    const ExactPlacement rate = exact_placement(motion.columns, motion.translation);
    const Rational seconds = exact(time);
    for (std::size_t i = 0; i < 3; ++i) at.columns[i] = at.columns[i] + seconds * rate.columns[i];
    at.translation = at.translation + seconds * rate.translation;
    return intersect_before(before(at, exact_line(ray)), shape, ray.range, sides);
}

}  // namespace raylab::oracle
