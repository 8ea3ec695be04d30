#include "15e_jittered_point/slot.h"
#include "arguments.h"
#include "cells.h"
#include "exercise_list.h"
#include "known.h"
#include "picture.h"
#include "sketch.h"
#include "spread_judgement.h"
#include "symptoms.h"
#include "whole_numbers.h"

#include <algorithm>
#include <cmath>

namespace raylab::grading {

namespace {

using namespace jitter;

std::vector<Case> jitter_cases(std::uint64_t seed) {
    Dice dice(seed);
    std::vector<Case> all;
    const auto add = [&](const std::string& group, int count, Case::Kind kind = Case::Kind::graded) {
        all.push_back({group, kind, {double(count), spread_seed(dice, cells_in_turn(all.size()))}});
    };
    const auto primes = std::array{5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61};
    add("a single cell", 1);
    for (const int side : {2, 3, whole(dice, 4, 6), whole(dice, 7, 8)}) add("a square number of cells", side * side);
    for (const int side : {1, whole(dice, 2, 4), whole(dice, 5, 7)})
        add("a number times the next one", side * (side + 1));
    for (const int from : {0, 4, 8, 12})
        add("a prime number of cells", primes[static_cast<std::size_t>(from + whole(dice, 0, 3))]);
    for (int i = 0; i < 4; ++i) add("any number of cells", whole(dice, 10, 64));
    for (const int count : {9, 25, 64})
        all.push_back({"numbers up to 1 - 2^-53", Case::Kind::graded, {double(count), numbers::at_ends}});
    all.push_back({"numbers rounded up to 1", Case::Kind::adversarial, {16, numbers::rounded_to_one}});
    return all;
}

Judgement wrong(std::string expected, std::string got) {
    return {Judgement::Outcome::wrong, std::move(expected), std::move(got)};
}

std::string point_in_words(const Case& question, std::span<const double> answer, std::size_t i) {
    const auto [u, v] = number_pairs(question.input[1])[i];
    return fmt::format("({}, {}) for cell {}, u = {}, v = {}", answer[2 * i], answer[2 * i + 1],
                       cell_of_pair(i, count_of(question.input)), u, v);
}

Judgement judge_jitter(const Case& question, std::span<const double> answer) {
    if (!all_finite(answer)) return {Judgement::Outcome::nonfinite, "points of the unit square", "no number"};
    const bool ends_count = question.input[1] == numbers::at_ends;
    for (std::size_t i = 0; i < pairs; ++i)
        for (const double x : {answer[2 * i], answer[2 * i + 1]})
            if (!(x >= 0 && (ends_count ? x < 1 : x <= 1)))
                return wrong("coordinates from 0 up to 1, and never 1", point_in_words(question, answer, i));
    const auto boxes = boxes_of(count_of(question.input), answer);
    if (const auto fault = fault_of(boxes)) return wrong(fault->expected, fault->got);
    const auto shares = shares_in_cells(boxes, answer);
    for (std::size_t i = 0; i < pairs; ++i)
        for (const double share : {shares[i].inside, shares[i].turn})
            if (!(share >= -rounding && share <= 1 + rounding))
                return wrong(
                    "a point of " + in_words(cell_of_pair(i, boxes.size()), boxes[cell_of_pair(i, boxes.size())]),
                    point_in_words(question, answer, i));
    const PointWords words{"cells of equal area, points all over them", "points all over their cells",
                           "places across them", "places upward"};
    if (!are_spread(question.input[1])) return {Judgement::Outcome::right, words.right, words.right};
    const auto uneven = uneven_part(shares, cells_of(question.input[1]));
    if (!uneven) return judged_by_steps(shares, words);
    const std::string where =
        fmt::format("of the points {:g} to {:g} of the way across their cells, {:g} to {:g} upward",
                    uneven->from_inside, uneven->to_inside, uneven->from_turn, uneven->to_turn);
    return wrong(fmt::format("{:.4g} % {}", 100 * uneven->expected, where),
                 fmt::format("{:.4g} %", 100 * uneven->found));
}

std::string jitter_story(const Case& question) {
    return fmt::format("count      {}\nnumbers    {}", question.input[0], numbers_in_words(question.input[1]));
}

}  // namespace

Exercise jittered_point_exercise() {
    return exercise_on(jittered_point_slot, answer,
                       {.inputs = inputs,
                        .outputs = outputs,
                        .cases = jitter_cases,
                        .judge = judge_jitter,
                        .symptoms = symptoms(),
                        .fingerprint_noise = 1e-12,  // a coordinate of 1 is wrong, and one of 1 - 1e-9 in another way
                        .story = jitter_story,
                        .sketch = sketch,
                        .picture = jitter_picture()});
}

}  // namespace raylab::grading
