#include "raylab/geometry/filter/prepared_flat.h"

#include "raylab/geometry/dominant_axis.h"
#include "raylab/geometry/filter/moved_origin.h"
#include "raylab/geometry/predicate/flat_intersection.h"

#include <cmath>

namespace raylab {

namespace {

constexpr double u64 = unit_roundoff<double>;

Vec3d magnitude(const Vec3d& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }
double sum(const Vec3d& v) { return v.x + v.y + v.z; }

// The axis that flat_intersection.h projects along is computed exactly.
int exact_dominant_axis(const Polygon& polygon) {
    Signs<Dyadic> signs;
    return static_cast<int>(dominant_axis(newell_normal<Dyadic>(polygon), signs));
}

}  // namespace

PreparedFlat::PreparedFlat(const Plane& plane)
    : plane_(plane), normal_(convert<double>(plane.normal)), extent_(Everything{}) {}

PreparedFlat::PreparedFlat(const Disk& disk)
    : plane_(disk), normal_(convert<double>(disk.normal)), extent_(Circle{disk.radius}) {}

PreparedFlat::PreparedFlat(const Annulus& annulus)
    : plane_(annulus),
      normal_(convert<double>(annulus.normal)),
      extent_(Ring{{annulus.inner_radius}, {annulus.outer_radius}}) {}

PreparedFlat::PreparedFlat(const Polygon& polygon) : PreparedFlat(polygon, newell_normal<Enclosure>(polygon)) {}

PreparedFlat::PreparedFlat(const Polygon& polygon, const Vec3<Enclosure>& normal)
    : plane_(polygon),
      normal_{normal.x.middle(), normal.y.middle(), normal.z.middle()},
      extent_(outline(polygon, normal)) {}

PreparedFlat::Outline PreparedFlat::outline(const Polygon& polygon, const Vec3<Enclosure>& normal) {
    const auto [first, second] = other_axes(exact_dominant_axis(polygon));
    Outline outline{{normal.x.radius(), normal.y.radius(), normal.z.radius()}, first, second, {}};
    for (const Vec3f& v : polygon.vertices) outline.vertices.push_back({v[first], v[second]});
    outline.vertices.push_back(outline.vertices.front());
    return outline;
}

std::size_t PreparedFlat::bytes() const {
    const auto* outline = std::get_if<Outline>(&extent_);
    return sizeof *this + (outline ? outline->vertices.capacity() * sizeof outline->vertices[0] : 0);
}

FilterVerdict PreparedFlat::filter(const Ray& ray, Sides sides) const {
    return filter_seen_from_point(convert<double>(ray.origin) - point(), convert<double>(ray.direction), {}, ray.range,
                                  sides);
}

FilterVerdict PreparedFlat::filter(const Ray& ray, const Affine& placement, const Motion& motion, Sides sides) const {
    const auto origin = origin_from_moved(ray, convert<float>(point()), placement, motion);  // a float's point
    return origin ? filter_seen_from_point(*origin, convert<double>(ray.direction), {}, ray.range, sides) : Undecided{};
}

// A vector is no longer than the sum of its coordinates' sizes.
FilterVerdict PreparedFlat::filter(const CarriedRay& ray, Sides sides) const {
    const auto off = [](const Vec3d& v) { return CarriedRay::off * sum(magnitude(v)); };
    return filter_seen_from_point(ray.origin, ray.direction, {off(ray.origin), off(ray.direction)}, ray.range, sides);
}

// The ray crosses the plane at t = -n.o / n.d, with its origin o as seen from the plane's point. With exact n (floats),
// products of n and d are exact, those of n and o carry o's rounding and their own, and each sum of three two more: 3 u
// and 5 u of the sums of magnitudes, one unit to spare for the bounds' own rounding. Floats in doubles neither over-
// nor underflow there; what is carried back is no float, but then a millionth of what it is off is more than all that.
FilterVerdict PreparedFlat::filter_seen_from_point(const Vec3d& o, const Vec3d& d, const Off& off,
                                                   const Interval<float>& range, Sides sides) const {
    const Vec3d n = magnitude(normal_), d_size = magnitude(d), o_size = magnitude(o);
    const double speed = dot(normal_, d), height = -dot(normal_, o);
    double speed_error = 4 * u64 * dot(n, d_size), height_error = 6 * u64 * dot(n, o_size);
    double spread = sum(n);
    if (const auto* outline = std::get_if<Outline>(&extent_)) {
        speed_error += dot(outline->normal_error, d_size) * (1 + 8 * u64);
        height_error += dot(outline->normal_error, o_size) * (1 + 8 * u64);
        spread += sum(outline->normal_error);
    }
    speed_error += off.direction * spread * (1 + 8 * u64);
    height_error += off.origin * spread * (1 + 8 * u64);
    const double room = std::abs(speed) - speed_error;
    if (!(room > 0)) return Undecided{};
    if (sides != Sides::both && !sees(sides, sign(speed))) return Miss{};

    const double t = height / speed, slowness = 1 / room;  // quotients that do not wait for each other
    const double t_error =
        ((height_error + std::abs(t) * speed_error) * slowness + 2 * u64 * std::abs(t)) * (1 + 16 * u64);
    if (t + t_error < range.min || t - t_error > range.max) return Miss{};
    if (!(t - t_error > range.min && t + t_error < range.max) || !is_accurate(t, t_error)) return Undecided{};

    const Flight flight{o, d, t, t_error, off.at(t, t_error)};
    const Inside found = std::visit([&](const auto& extent) { return inside(extent, flight); }, extent_);
    if (found == Inside::unknown) return Undecided{};
    if (found == Inside::no) return Miss{};
    return Candidate{t, t_error};
}

PreparedFlat::Point PreparedFlat::Flight::end() const {
    const Vec3d way = direction * t;
    return {origin + way, magnitude(direction) * (t_error * (1 + 4 * u64)) +
                              3 * u64 * (magnitude(origin) + magnitude(way)) + Vec3d(off * (1 + 4 * u64))};
}

// Most points are far from the rim. One that is known to 2^-22 of the radius, and whose distance as computed differs
// from it by 2^-20 and more, needs no better bound than the sum of the coordinates' errors.
PreparedFlat::Inside PreparedFlat::clearly_inside(const Circle& circle, const Flight& flight) const {
    const double way = sum(magnitude(flight.direction));
    const double error = way * (flight.t_error + 4 * u64 * std::abs(flight.t)) +
                         4 * u64 * sum(magnitude(flight.origin)) + 4 * flight.off;
    const Vec3d spoke = flight.origin + flight.direction * flight.t;
    const double square = dot(spoke, spoke), limit = circle.radius * circle.radius;
    if (!(error < circle.radius * 0x1p-22)) return Inside::unknown;
    if (square < limit * (1 - 0x1p-19)) return Inside::yes;
    return square > limit * (1 + 0x1p-19) ? Inside::no : Inside::unknown;
}

// | |p + e|^2 - |p|^2 | <= (2 |p| + |e|) . |e|, and 6 u of the sum of squares for what rounding does to it.
PreparedFlat::Inside PreparedFlat::inside(const Circle& circle, const Flight& flight) const {
    if (const Inside found = clearly_inside(circle, flight); found != Inside::unknown) return found;
    const auto [spoke, error] = flight.end();
    const double square = dot(spoke, spoke), limit = circle.radius * circle.radius;
    const double error_bound = (dot(2.0 * magnitude(spoke) + error, error) + 6 * u64 * square) * (1 + 8 * u64);
    if (square + error_bound < limit * (1 - 4 * u64)) return Inside::yes;
    return square - error_bound > limit * (1 + 4 * u64) ? Inside::no : Inside::unknown;
}

// A point inside a circle is not on its rim, so a point inside the inner one is in the hole and does not belong to the
// shape.
PreparedFlat::Inside PreparedFlat::inside(const Ring& ring, const Flight& flight) const {
    const Inside in_outer = inside(ring.outer, flight);
    if (in_outer == Inside::no) return Inside::no;
    const Inside in_hole = inside(ring.inner, flight);
    if (in_hole == Inside::yes) return Inside::no;
    return in_outer == Inside::yes && in_hole == Inside::no ? Inside::yes : Inside::unknown;
}

// The even-odd rule for the computed point, which is sure for it; and for the exact one too, if no edge passes between
// the two: each edge is farther away than the point is uncertain. cross = (b - a) x (p - a) errs by 6 u of its terms.
PreparedFlat::Inside PreparedFlat::inside(const Outline& outline, const Flight& flight) const {
    const auto& [normal_error, first, second, vertices] = outline;
    const Point end = flight.end();
    const auto [first_x, first_y] = vertices.front();  // the plane's point
    const double x = first_x + end.at[first], y = first_y + end.at[second];
    const double dx = (end.error[first] + u64 * std::abs(x)) * (1 + 4 * u64);
    const double dy = (end.error[second] + u64 * std::abs(y)) * (1 + 4 * u64);
    bool inside = false;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
        const auto [ax, ay] = vertices[i];
        const auto [bx, by] = vertices[i + 1];
        if (std::max(ay, by) + dy < y || std::min(ay, by) - dy > y || std::max(ax, bx) + dx < x) continue;
        const double along = (bx - ax) * (y - ay), across = (by - ay) * (x - ax);
        const double cross = along - across;
        const double error_bound = 6 * u64 * (std::abs(along) + std::abs(across)) +
                                   (std::abs(bx - ax) * dy + std::abs(by - ay) * dx) * (1 + 8 * u64);
        const bool beside =
            std::min(ax, bx) - dx > x;  // wholly on the half axis's side: sure whatever the cross product
        if (!beside && std::abs(cross) <= error_bound) return Inside::unknown;
        const bool upward = ay <= y && by > y, downward = by <= y && ay > y;
        if (beside ? upward || downward : (upward && cross > 0) || (downward && cross < 0)) inside = !inside;
    }
    return inside ? Inside::yes : Inside::no;
}

}  // namespace raylab
