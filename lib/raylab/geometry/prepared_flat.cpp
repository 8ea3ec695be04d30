#include "raylab/geometry/prepared_flat.h"

#include "raylab/geometry/dominant_axis.h"
#include "raylab/geometry/meet_flat.h"

#include <cmath>

namespace raylab {

namespace {

constexpr double u64 = unit_roundoff<double>;

Vec3d magnitude(const Vec3d& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

// The axis that meet_flat.h projects along, exactly.
int exact_dominant_axis(const Polygon& polygon) {
    Signs<Dyadic> signs;
    return static_cast<int>(dominant_axis(newell_normal<Dyadic>(polygon), signs));
}

}  // namespace

PreparedFlat::PreparedFlat(const Plane& plane)
    : extent_(Extent::unbounded), point_(convert<double>(plane.point)), normal_(convert<double>(plane.normal)) {}

PreparedFlat::PreparedFlat(const Disk& disk)
    : extent_(Extent::disk),
      point_(convert<double>(disk.center)),
      normal_(convert<double>(disk.normal)),
      radius_(disk.radius) {}

PreparedFlat::PreparedFlat(const Polygon& polygon)
    : extent_(Extent::polygon), point_(convert<double>(polygon.vertices.front())) {
    const Vec3<Enclosure> normal = newell_normal<Enclosure>(polygon);
    normal_ = {normal.x.middle(), normal.y.middle(), normal.z.middle()};
    normal_error_ = {normal.x.radius(), normal.y.radius(), normal.z.radius()};
    const auto axes = other_axes(exact_dominant_axis(polygon));
    first_ = axes.first;
    second_ = axes.second;
    for (const Vec3f& v : polygon.vertices) outline_.push_back({v[first_], v[second_]});
    outline_.push_back(outline_.front());
}

// The plane is met at t = n.(point - origin) / n.d. With exact n (floats), products of n and d are exact, those of n and
// f = point - origin carry f's rounding and their own, and each sum of three two more: 3 u and 5 u of the sums of
// magnitudes, one unit to spare for the bounds' own rounding. Floats in doubles neither over- nor underflow there.
FilterVerdict PreparedFlat::meet(const Ray& ray, Sides sides) const {
    const Vec3d d = convert<double>(ray.direction), o = convert<double>(ray.origin), f = point_ - o;
    const Vec3d n = magnitude(normal_), d_size = magnitude(d), f_size = magnitude(f);
    const double speed = dot(normal_, d), height = dot(normal_, f);
    double speed_error = 4 * u64 * dot(n, d_size), height_error = 6 * u64 * dot(n, f_size);
    if (extent_ == Extent::polygon) {
        speed_error += dot(normal_error_, d_size) * (1 + 8 * u64);
        height_error += dot(normal_error_, f_size) * (1 + 8 * u64);
    }
    const double room = std::abs(speed) - speed_error;
    if (!(room > 0)) return Undecided{};
    if (sides != Sides::both && !sees(sides, sign(speed))) return Miss{};

    const double t = height / speed;
    const double t_error = ((height_error + std::abs(t) * speed_error) / room + 2 * u64 * std::abs(t)) * (1 + 16 * u64);
    if (t + t_error < ray.range.min || t - t_error > ray.range.max) return Miss{};
    if (!(t - t_error > ray.range.min && t + t_error < ray.range.max) || !is_accurate(t, t_error)) return Undecided{};

    const Inside found = inside(Flight{o, d, t, t_error});
    if (found == Inside::unknown) return Undecided{};
    if (found == Inside::no) return Miss{};
    return Candidate{t, t_error};
}

PreparedFlat::Inside PreparedFlat::inside(const Flight& flight) const {
    if (extent_ == Extent::unbounded) return Inside::yes;
    if (extent_ == Extent::disk)
        if (const Inside found = clearly_inside_disk(flight); found != Inside::unknown) return found;
    const Point point = flight.end();
    return extent_ == Extent::disk ? inside_disk(point) : inside_polygon(point);
}

PreparedFlat::Point PreparedFlat::Flight::end() const {
    const Vec3d way = direction * t;
    return {origin + way, magnitude(direction) * (t_error * (1 + 4 * u64)) + 3 * u64 * (magnitude(origin) + magnitude(way))};
}

// Most points are far from the rim. One that is known to 2^-22 of the radius, and whose distance as computed differs from it by
// 2^-20 and more, needs no better bound than the sum of the coordinates' errors.
PreparedFlat::Inside PreparedFlat::clearly_inside_disk(const Flight& flight) const {
    const auto sum_of = [](const Vec3d& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
    const double way = sum_of(flight.direction);
    const double error = way * (flight.t_error + 4 * u64 * std::abs(flight.t)) + 4 * u64 * (sum_of(flight.origin) + sum_of(point_));
    const Vec3d spoke = flight.origin + flight.direction * flight.t - point_;
    const double square = dot(spoke, spoke), limit = radius_ * radius_;
    if (!(error < radius_ * 0x1p-22)) return Inside::unknown;
    if (square < limit * (1 - 0x1p-19)) return Inside::yes;
    return square > limit * (1 + 0x1p-19) ? Inside::no : Inside::unknown;
}

// | |p + e|^2 - |p|^2 | <= (2 |p| + |e|) . |e|, and 6 u of the sum of squares for what rounding does to it.
PreparedFlat::Inside PreparedFlat::inside_disk(const Point& point) const {
    const Vec3d spoke = point.at - point_;
    const Vec3d error = point.error + u64 * magnitude(spoke);
    const double square = dot(spoke, spoke), limit = radius_ * radius_;
    const double doubt = (dot(2.0 * magnitude(spoke) + error, error) + 6 * u64 * square) * (1 + 8 * u64);
    if (square + doubt < limit * (1 - 4 * u64)) return Inside::yes;
    return square - doubt > limit * (1 + 4 * u64) ? Inside::no : Inside::unknown;
}

// The even-odd rule for the computed point, which is sure for it; and for the exact one too, if no edge passes between
// the two: each edge is farther away than the point is uncertain. cross = (b - a) x (p - a) errs by 6 u of its terms.
PreparedFlat::Inside PreparedFlat::inside_polygon(const Point& point) const {
    const double x = point.at[first_], y = point.at[second_];
    const double dx = point.error[first_], dy = point.error[second_];
    bool inside = false;
    for (std::size_t i = 0; i + 1 < outline_.size(); ++i) {
        const auto [ax, ay] = outline_[i];
        const auto [bx, by] = outline_[i + 1];
        if (std::max(ay, by) + dy < y || std::min(ay, by) - dy > y || std::max(ax, bx) + dx < x) continue;
        const double along = (bx - ax) * (y - ay), across = (by - ay) * (x - ax);
        const double cross = along - across;
        const double doubt = 6 * u64 * (std::abs(along) + std::abs(across)) +
                             (std::abs(bx - ax) * dy + std::abs(by - ay) * dx) * (1 + 8 * u64);
        const bool beside = std::min(ax, bx) - dx > x;  // wholly on the half axis's side: sure whatever the cross product
        if (!beside && std::abs(cross) <= doubt) return Inside::unknown;
        const bool upward = ay <= y && by > y, downward = by <= y && ay > y;
        if (beside ? upward || downward : (upward && cross > 0) || (downward && cross < 0)) inside = !inside;
    }
    return inside ? Inside::yes : Inside::no;
}

}  // namespace raylab
