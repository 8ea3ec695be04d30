#include "raylab/accelerator/boxed_list.h"

#include "raylab/accelerator/list.h"

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
            primitives_.test(rows.numbers[place], ray, nearest, traversal);
            open &= ~(Places{1} << place);
        }
    }
    return nearest.hit();
}

bool BoxedList::occluded(const Ray& ray, Traversal& traversal) const {
    if (traversal.stopped_again([&](std::size_t i) { return primitives_.hits(i, ray, traversal); })) return true;
    if (goes_back(ray)) return occluded_by_any(primitives_, ray, traversal);
    return std::ranges::any_of(rows_, [&](const ShapeRows& rows) { return stops(rows, ray, traversal); });
}

// A sphere is found again as soon as it is remembered: blockers are others.
bool BoxedList::stops(const ShapeRows& rows, const Ray& ray, Traversal& traversal) const {
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

}  // namespace raylab
