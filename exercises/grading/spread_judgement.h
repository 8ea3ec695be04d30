#pragma once

#include "case.h"
#include "spread.h"

#include <span>
#include <string>

// What is judged of points that are spread evenly: whether there is nothing between them.

namespace raylab::grading {

/// How an exercise calls its points.
struct PointWords {
    std::string right;           // "points all over the lens, evenly"
    std::string in_no_steps;     // "points in all directions, at all distances"
    std::string insides, turns;  // "distances", "directions from the centre"
};

/// The judgement of points that are spread evenly: they are right, unless something was rounded to whole steps.
inline Judgement judged_by_steps(std::span<const DrawnShare> points, const PointWords& words) {
    const auto steps = steps_of(points);
    if (!steps) return {Judgement::Outcome::right, words.right, words.right};
    return {Judgement::Outcome::wrong, words.in_no_steps, steps_in_words(*steps, words.insides, words.turns)};
}

}  // namespace raylab::grading
