#include "raylab/accelerator/shape_rows/boxed_list.h"

#include "raylab/accelerator/list.h"

#include <algorithm>
#include <bit>

namespace raylab {

namespace {

using Places = std::uint32_t;  // a bit for each

std::size_t lowest(Places places) { return static_cast<std::size_t>(std::countr_zero(places)); }

// The place of the shape that is to be tested first: a sphere if there is one, since they stand in front and count as
// entered at 0, or what is entered first.
std::size_t entered_first(Places places, const ShapeRows& rows, const RowQuestions::Entries& entries) {
    std::size_t first = lowest(places);
    if (first < rows.sphere_count) return first;
    for (Places left = places & (places - 1); left != 0; left &= left - 1)
        if (const std::size_t other = lowest(left); entries[other] < entries[first]) first = other;
    return first;
}

bool is_entered(Places places, const RowQuestions::Entries& entries, double limit) {
    for (; places != 0; places &= places - 1)
        if (entries[lowest(places)] <= limit) return true;
    return false;
}

// The questions about all shapes at once are about t >= 0.
bool goes_back(const Ray& ray) { return !(ray.range.min >= 0); }

}  // namespace

BoxedList::BoxedList(const Scene& scene) : primitives_(scene), rows_(in_rows(primitives_)), ask_(best_row_questions()) {
    balls_.resize(scene.objects.size());
    for (std::size_t i = 0; i < primitives_.size(); ++i)
        if (const auto sphere = primitives_.whole_sphere(i)) balls_[primitives_.primitive(i).object].emplace(*sphere);
}

// A sphere's filter is short enough to stand in the loop, 0.8 % of the picture of tests/bench/mirror_and_glass.toml;
// what it leaves open goes the long way.
inline std::optional<Candidate> BoxedList::candidate(const ShapeRows& rows, std::size_t place, const Ray& ray,
                                                     Traversal& traversal) const {
    using What = sphere_filter::SphereVerdict::What;
    const std::uint32_t number = rows.numbers[place];
    if (place >= rows.sphere_count) return primitives_.candidate(number, ray, traversal);
    const auto found = sphere_filter::decide(convert<double>(ray.origin), convert<double>(ray.direction), ray.range,
                                             rows.ball(place), Sides::both);
    if (found.what == What::undecided) return primitives_.candidate(number, ray, traversal);
    ++traversal.primitive_tests;
    if (found.what == What::missed) return std::nullopt;
    return Candidate{found.at.t, found.at.error};
}

inline void BoxedList::test(const ShapeRows& rows, Places open, const RowQuestions::Entries& entries, const Ray& ray,
                            Nearest& nearest, Traversal& traversal) const {
    while (open != 0) {
        const std::size_t place = entered_first(open, rows, entries);
        if (entries[place] > nearest.limit()) break;
        if (const auto found = candidate(rows, place, ray, traversal))
            primitives_.offer(rows.numbers[place], *found, nearest, traversal);
        open &= ~(Places{1} << place);
    }
}

// Mostly a handful has one row, and the shape that is entered first is hit before any other is entered: then there is
// nothing to be compared.
std::optional<Hit> BoxedList::closest(const Ray& ray, Traversal& traversal) const {
    if (rows_.size() != 1 || goes_back(ray)) return closest_of_rows(ray, traversal);
    const ShapeRows& rows = rows_[0];
    traversal.box_tests += rows.size();
    RowQuestions::Entries entries;
    const Places open = ask_.open(rows, ray, ray.range.max, entries);
    if (open == 0) return std::nullopt;
    const std::size_t place = entered_first(open, rows, entries);
    const Places others = open & ~(Places{1} << place);
    const auto found = candidate(rows, place, ray, traversal);
    if (!found ? others != 0 : is_entered(others, entries, Nearest::limit(*found)))
        return closest_of_open(others, entries, ray, {place, found}, traversal);
    if (!found) return std::nullopt;
    return Hit{found->t, primitives_.primitive(rows.numbers[place]), found->u, found->v, found->part};
}

[[gnu::noinline]] std::optional<Hit> BoxedList::closest_of_open(Places open, const RowQuestions::Entries& entries,
                                                                const Ray& ray, const Met& first,
                                                                Traversal& traversal) const {
    Nearest nearest(ray);
    if (first.found) primitives_.offer(rows_[0].numbers[first.place], *first.found, nearest, traversal);
    test(rows_[0], open, entries, ray, nearest, traversal);
    return nearest.hit();
}

[[gnu::noinline]] std::optional<Hit> BoxedList::closest_of_rows(const Ray& ray, Traversal& traversal) const {
    if (goes_back(ray)) return closest_of_all(primitives_, ray, traversal);
    Nearest nearest(ray);
    RowQuestions::Entries entries;
    for (const ShapeRows& rows : rows_) {
        traversal.box_tests += rows.size();
        const Places open = ask_.open(rows, ray, std::min<double>(ray.range.max, nearest.limit()), entries);
        test(rows, open, entries, ray, nearest, traversal);
    }
    return nearest.hit();
}

// A sphere is found again as soon as it is remembered: blockers are others.
inline bool BoxedList::stops(const ShapeRows& rows, const Ray& ray, Traversal& traversal) const {
    traversal.box_tests += rows.size();
    const auto [open, sure] = ask_.stops(rows, ray);
    if (sure != 0) return true;
    for (Places left = open; left != 0; left &= left - 1) {
        const std::size_t place = lowest(left);
        if (!primitives_.hits(rows.numbers[place], ray, traversal)) continue;
        if (place >= rows.sphere_count) traversal.stopped_by(rows.numbers[place]);
        return true;
    }
    return false;
}

// Whether the ray begins inside of the sphere that it leaves, as every one to a light outside of a ball of glass does
// from within, and is longer than the diameter: surely, since all numbers are known to a few units of 2^-53.
inline bool BoxedList::is_shut_in(const Ray& ray) const {
    const std::uint32_t object = ray.leaving.object;
    if (object >= balls_.size() || !balls_[object] || ray.range.min != 0 || !(ray.range.max > 0)) return false;
    const auto& [center, squared_radius] = *balls_[object];
    Vec3d from_center = convert<double>(ray.origin) - center,
          way = double{ray.range.max} * convert<double>(ray.direction);
    return dot(from_center, from_center) < (1 - 0x1p-40) * squared_radius &&
           dot(way, way) > (4 + 0x1p-40) * squared_radius;
}

bool BoxedList::occluded(const Ray& ray, Traversal& traversal) const {
    if (is_shut_in(ray)) return true;
    if (traversal.stopped_again([&](std::size_t i) { return primitives_.hits(i, ray, traversal); })) return true;
    if (goes_back(ray)) return occluded_by_any(primitives_, ray, traversal);
    for (const ShapeRows& rows : rows_)
        if (stops(rows, ray, traversal)) return true;
    return false;
}

}  // namespace raylab
