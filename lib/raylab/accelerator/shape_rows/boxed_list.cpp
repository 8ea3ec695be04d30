#include "raylab/accelerator/shape_rows/boxed_list.h"

#include "raylab/accelerator/list.h"
#include "raylab/geometry/sphere_filter.h"

#include <algorithm>
#include <bit>

namespace raylab {

namespace {

using Places = std::uint32_t;  // a bit for each

std::size_t lowest(Places places) { return static_cast<std::size_t>(std::countr_zero(places)); }

std::size_t entered_first(Places places, const RowQuestions::Entries& entries) {
    std::size_t first = lowest(places);
    for (Places left = places & (places - 1); left != 0; left &= left - 1)
        if (const std::size_t other = lowest(left); entries[other] < entries[first]) first = other;
    return first;
}

// What is asked at once is about t >= 0.
bool goes_back(const Ray& ray) { return !(ray.range.min >= 0); }

}  // namespace

BoxedList::BoxedList(const Scene& scene) : primitives_(scene), rows_(in_rows(primitives_)), ask_(best_row_questions()) {}

// A sphere's filter is short enough to stand here; what it leaves open goes the long way.
void BoxedList::test(const ShapeRows& rows, std::size_t place, const Ray& ray, Nearest& nearest, Traversal& traversal) const {
    using What = sphere_filter::Verdict::What;
    const std::uint32_t number = rows.numbers[place];
    if (place >= rows.sphere_count) return primitives_.test(number, ray, nearest, traversal);
    const Target target = primitives_.target(number);
    const sphere_filter::Verdict found = sphere_filter::decide(ray, std::get<Sphere>(*target.shape), Sides::both);
    if (found.what == What::undecided) return primitives_.test(number, ray, nearest, traversal);
    ++traversal.primitive_tests;
    if (found.what == What::missed) return;
    Decisions decisions;
    nearest.offer(Candidate{found.at.t, found.at.error}, target, primitives_.primitive(number), decisions);
    traversal.exact_decisions += decisions.exact;
}

std::optional<Hit> BoxedList::closest(const Ray& ray, Traversal& traversal) const {
    if (goes_back(ray)) return closest_of_all(primitives_, ray, traversal);
    Nearest nearest(ray);
    RowQuestions::Entries entries;
    for (const ShapeRows& rows : rows_) {
        traversal.box_tests += rows.size();
        Places open = ask_.open(rows, ray, std::min<double>(ray.range.max, nearest.limit()), entries);
        while (open != 0) {
            const std::size_t place = entered_first(open, entries);
            if (entries[place] > nearest.limit()) break;
            test(rows, place, ray, nearest, traversal);
            open &= ~(Places{1} << place);
        }
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

bool BoxedList::occluded(const Ray& ray, Traversal& traversal) const {
    if (traversal.stopped_again([&](std::size_t i) { return primitives_.hits(i, ray, traversal); })) return true;
    if (goes_back(ray)) return occluded_by_any(primitives_, ray, traversal);
    for (const ShapeRows& rows : rows_)
        if (stops(rows, ray, traversal)) return true;
    return false;
}

}  // namespace raylab
