#pragma once

#include "given_point.h"

#include <fmt/format.h>

// What wrong answers to this exercise have in common. A right answer is any point of a cell, so that they are told by
// where the point lies.

namespace raylab::grading::next_cell {

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    // Where it need not be wrong it may be, near a side or by rounding.
    const auto add_allowed = [&](Symptom symptom) {
        symptom.allows = symptom.shows;
        add(std::move(symptom));
    };
    add({"zero_divided", "a coordinate of the direction is 0",
         [](const WrongAnswer& w) { return is_parallel(w.question); }, is_parallel});
    add({"small_is_not_zero", "the direction is less than a millionth long",
         [](const WrongAnswer& w) { return is_short(w.question); }, is_short});
    for (const double limit : {1e-8, 1e-4})
        add({"small_is_not_zero", fmt::format("the ray leaves at a t below {:g}", limit),
             [limit](const WrongAnswer& w) { return leaves_at(w.question) < limit; },
             [limit](const Case& q) { return leaves_at(q) < limit; }});
    add({"cut_towards_zero",
         "the place is negative along an axis, and the point is one smallest cell too far up along it",
         [](const WrongAnswer& w) { return is_a_cell_beside(w, true); }, leaves_at_negative_place});
    add({"nearest_border", "the point is one smallest cell too far up along an axis that is not crossed",
         [](const WrongAnswer& w) { return is_a_cell_beside(w, false); }});
    for (const double times : {0.5, 1.0, 0.25, 0.1})
        add({"step_by_direction",
             "the point is right beside, and the farther beyond the face the longer the direction is",
             [times](const WrongAnswer& w) {
                 const double cells = times * speed_across(w.question);
                 return is_beside(w, 0.01) && std::abs(beyond(w) - cells) < 1e-6 * (1 + beyond(w));
             },
             [times](const Case& q) { return leaves_the_first_cell(times * speed_across(q)); }});
    for (const double times : {1.0, 0.5, 0.1, 0.01, 1e-3})
        add_allowed(
            {"step_by_direction",
             "the point is right beside, and beyond the face by the direction times a number, for cells of any size",
             [times](const WrongAnswer& w) {
                 const double metres = times * speed_across(w.question), smallest = of(w.question).smallest;
                 return is_beside(w, 0.01) && std::abs(beyond(w) * smallest - metres) < 1e-6 * (metres + smallest);
             },
             [times](const Case& q) { return leaves_the_first_cell(times * speed_across(q) / of(q).smallest); }});
    for (const double times : {0.5, 1.0, 0.25, 0.1, 0.01, 1e-3})
        add_allowed({"step_by_direction",
                     "the point lies on the ray, and the farther beyond its exit the longer the direction is",
                     [times](const WrongAnswer& w) {
                         const auto [cube, smallest, origin, direction] = of(w.question);
                         const double step = times * smallest * glm::length(direction);
                         return lies_on_the_ray(w) && std::abs(length_beyond(w) - step) < 1e-6 * (step + smallest);
                     },
                     [times](const Case& q) { return leaves_the_first_cell(times * speed_across(q)); }});
    for (const double metres : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10})
        add_allowed(
            {"fixed_step", "the point is right beside, and as many metres beyond the face for cells of any size",
             [metres](const WrongAnswer& w) {
                 const double size = std::max(glm::length(exit_point(w.question)), of(w.question).cube.side);
                 return is_beside(w, 0.01) && is_one_of(beyond(w) * of(w.question).smallest, {metres}, 1e-15 * size);
             },
             [metres](const Case& q) { return leaves_the_first_cell(metres / of(q).smallest); }});
    for (const double t : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9})
        add_allowed({"fixed_step", "the point lies on the ray, and as much t beyond its exit for cells of any size",
                     [t](const WrongAnswer& w) {
                         const auto given = of(w.question);
                         const double size = glm::length(given.origin) + glm::length(exit_point(w.question));
                         const double step = t * glm::length(given.direction);
                         return lies_on_the_ray(w) && std::abs(length_beyond(w) - step) < 1e-3 * step + 1e-15 * size;
                     },
                     [t](const Case& q) { return leaves_the_first_cell(t * speed_across(q) / of(q).smallest); }});
    add({"on_the_face", "the point lies on the face, or a rounding error beside it",
         [](const WrongAnswer& w) { return std::abs(beyond(w)) < 1e-6 && is_beside(w, 1e-3); }});
    add({"too_far", "the point is right beside, and one smallest cell or more beyond the face, whatever lies there",
         [](const WrongAnswer& w) {
             return is_beside(w, 0.01) && is_one_of(beyond(w), {1, 1.5, 2, 2.5, 3, 4});
         }});
    add({"own_size", "the point is right beside, and a half, a quarter or all of this cell's size beyond the face",
         [](const WrongAnswer& w) {
             const auto [cube, smallest, origin, direction] = of(w.question);
             const double sides = beyond(w) * smallest / cube.side;
             return beyond(w) > 1 - 1e-6 && is_beside(w, 0.01) && cube.side > smallest &&
                    is_one_of(sides, {0.25, 0.5, 0.75, 1});
         },
         [](const Case& q) { return of(q).cube.side > of(q).smallest; },
         [](const WrongAnswer& w) { return beyond(w) > 1 - 1e-6 && is_beside(w, 0.01); }});
    add({"fixed_step", "the point is right beside, and as many metres beyond the face for cells of any size",
         [](const WrongAnswer& w) {
             const double smallest = of(w.question).smallest;
             return is_beside(w, 0.01) && is_one_of(beyond(w) * smallest, {1, 0.5, 0.25, 0.1, 0.05, 0.01, 1e-3, 1e-4});
         },
         has_tiny_cells});
    all.back().allows = all.back().shows;  // larger cells may hide it
    add({"own_size", "the point is right beside, and a smallest cell or two too far beyond the face",
         [](const WrongAnswer& w) { return beyond(w) > 1 - 1e-6 && beyond(w) < 3 && is_beside(w, 0.01); },
         has_tiny_cells});
    all.back().allows = all.back().shows;
    add({"wrong_way", "the point is right beside, and before the face: still in this cell",
         [](const WrongAnswer& w) { return beyond(w) < -1e-6 && beyond(w) > -1 && is_beside(w, 0.01); }});
    add({"fixed_step", "the point lies on the ray, as many metres, or as much t, beyond its exit for cells of any size",
         [](const WrongAnswer& w) {
             const double far = length_beyond(w), length = glm::length(of(w.question).direction);
             const double rounding = 1e-15 * (glm::length(of(w.question).origin) + glm::length(exit_point(w.question)));
             const auto steps = {1.0, 0.5, 0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};
             return lies_on_the_ray(w) &&
                    (is_one_of(far, steps, rounding) || is_one_of(far / length, steps, rounding / length));
         },
         has_tiny_cells});
    all.back().allows = all.back().shows;  // larger cells may hide it
    add({"along_the_ray", "the point lies on the ray, up to a smallest cell beyond where it leaves, or beyond the face",
         [](const WrongAnswer& w) {
             const double size = of(w.question).smallest, along = length_beyond(w) / size;
             return lies_on_the_ray(w) && !is_straight_across(w) && along > 0 && std::min(along, beyond(w)) <= 1 + 1e-6;
         }});
    add({"all_axes", "the point is beyond the face, and moved along the other axes, too", [](const WrongAnswer& w) {
             if (!(beyond(w) > 0 && beyond(w) < 1) || lies_on_the_ray(w)) return false;
             const Vec3d exit = exit_point(w.question);
             for (int axis = 0; axis < 3; ++axis) {
                 const double off =
                     std::abs(w.given[static_cast<std::size_t>(axis)] - exit[axis]) / of(w.question).smallest;
                 if (axis != across(w.question) && off > 1.01) return false;
             }
             return true;
         }});
    add({"from_the_middle", "the point is beyond the face, in its middle", [](const WrongAnswer& w) {
             const auto cube = of(w.question).cube;
             for (int axis = 0; axis < 3; ++axis)
                 if (axis != across(w.question) && std::abs(w.given[static_cast<std::size_t>(axis)] - cube.low[axis] -
                                                            cube.side / 2) > 1e-6 * cube.side)
                     return false;
             return beyond(w) > 0;
         }});
    add({"near_plane", "the point is where the ray comes in through one of the faces behind it",
         [](const WrongAnswer& w) {
             for (int axis = 0; axis < 3; ++axis)
                 if (of(w.question).direction[axis] != 0 && lies_on(w, axis, Side::behind)) return true;
             return false;
         }});
    add({"fixed_step", "the cells are of another size than 1, or about 1", [](const WrongAnswer& w) {
             const double smallest = of(w.question).smallest;
             return (smallest < 0.2 || smallest > 2) && (is_beside(w, 0.01) || lies_on_the_ray(w));
         }});
    add({"forward_only", "a coordinate of the direction is negative",
         [](const WrongAnswer& w) { return goes_backward(w.question) && !(is_beside(w, 0.01) && beyond(w) > -1e-6); },
         [](const Case& q) { return of(q).direction[across(q)] < 0 && moving_axes(q) > 1; },
         [](const WrongAnswer& w) { return goes_backward(w.question); }});
    add({"unit_direction",
         "the point is where the ray is at a t that is too large or too small by the direction's length",
         [](const WrongAnswer& w) {
             const double length = glm::length(of(w.question).direction);
             return std::abs(length - 1) > 1e-6 && !is_beside(w, 0.01) &&
                    (is_beside_at(w, length) || is_beside_at(w, 1 / length));
         }});
    add({"half_cell_along", "the point lies on the ray, too far along it",
         [](const WrongAnswer& w) { return length_beyond(w) > of(w.question).smallest / 2 && lies_on_the_ray(w); }});
    add({"last_plane", "the point is where the ray leaves through a face that it reaches later",
         [](const WrongAnswer& w) {
             const auto given = of(w.question);
             for (int axis = 0; axis < 3; ++axis)
                 if (axis != across(w.question) && given.direction[axis] != 0 && lies_on(w, axis, Side::ahead))
                     return true;
             return false;
         }});
    add({"on_the_face", "the point lies on the face, and right beside up to a smallest cell",
         [](const WrongAnswer& w) { return std::abs(beyond(w)) < 1e-6 && is_beside(w, 1); }});
    add({"origin_beside", "the point is beyond the face, and beside it where the ray began", lies_beside_the_origin});
    add({"too_far", "the point is in the right row of smallest cells, and one of them or more beyond the face",
         [](const WrongAnswer& w) { return is_beside(w, 1) && !is_beside(w, 0.01) && beyond(w) > 1 - 1e-6; }});
    add({"stays", "the point lies in the cell that the ray is to leave", is_inside_cube});
    return of_numbers(std::move(all), {"zero_divided"});
}

}  // namespace raylab::grading::next_cell
