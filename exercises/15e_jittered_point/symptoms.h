#pragma once

#include "cells.h"
#include "point_patterns.h"
#include "symptom.h"

// What wrong answers to this exercise have in common.

namespace raylab::grading::jitter {

inline std::vector<CellBox> boxes_of(const WrongAnswer& w) { return boxes_of(count_of(w.question.input), w.given); }

inline bool is_square(const Case& question) {
    const double side = std::sqrt(question.input[0]);
    return side == std::floor(side);
}
inline bool is_single(const Case& question) { return question.input[0] == 1; }

template <class Holds>
bool of_every_cell(const WrongAnswer& w, const Holds& holds) {
    return std::ranges::all_of(boxes_of(w), [&](const CellBox& box) { return holds(box); });
}

/// The area of each cell, as a share of what it should be, lies between these.
inline bool areas_between(const WrongAnswer& w, double least, double most) {
    const double count = w.question.input[0];
    return of_every_cell(w,
                         [&](const CellBox& box) { return box.area() * count > least && box.area() * count < most; });
}

inline bool overlap(const WrongAnswer& w) {
    const auto boxes = boxes_of(w);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (shared_area(boxes[i], boxes[k]) > rounding) return true;
    return false;
}

/// Two cells have the same place.
inline bool has_twins(const WrongAnswer& w) {
    const auto boxes = boxes_of(w);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (std::abs(boxes[i].left - boxes[k].left) + std::abs(boxes[i].low - boxes[k].low) < rounding) return true;
    return false;
}

inline double covered(const WrongAnswer& w) {
    double sum = 0;
    for (const CellBox& box : boxes_of(w)) sum += box.area();
    return sum;
}

/// Whether the cells begin at both of the square's lower sides.
inline bool begins_at_zero(const WrongAnswer& w) {
    double left = 1, low = 1;
    for (const CellBox& box : boxes_of(w)) {
        left = std::min(left, box.left);
        low = std::min(low, box.low);
    }
    return std::abs(left) < rounding && std::abs(low) < rounding;
}

/// Whether the cells that are farthest left and farthest below are whole cells off the square's sides.
inline bool is_whole_shift(const WrongAnswer& w) {
    const auto boxes = boxes_of(w);
    const auto left = std::ranges::min_element(boxes, {}, &CellBox::left);
    const auto low = std::ranges::min_element(boxes, {}, &CellBox::low);
    const auto is_whole = [](double shift) { return std::abs(shift - std::round(shift)) < 1e-6; };
    return is_whole(left->left / left->width()) && is_whole(low->low / low->height());
}

/// Whether the point of a pair is as far across its cell as it is up in it, or down, whatever the numbers were.
inline bool on_diagonals(const WrongAnswer& w) {
    const auto shares = shares_in_cells(boxes_of(w), w.given);
    const auto all = [&](const auto& off) {
        return std::ranges::all_of(shares, [&](const DrawnShare& share) { return std::abs(off(share)) < 1e-6; });
    };
    return all([](const DrawnShare& share) { return share.inside - share.turn; }) ||
           all([](const DrawnShare& share) { return share.inside + share.turn - 1; });
}

/// Whether the points of each cell lie on a line along one of its sides: those of the smallest and of the largest
/// numbers, between which its box is, and all others.
inline bool on_lines_along_sides(const WrongAnswer& w) {
    const auto boxes = boxes_of(w);
    for (const CellBox& box : boxes)
        if ((box.width() == 0) == (box.height() == 0)) return false;
    for (std::size_t i = 0; i < pairs; ++i) {
        const CellBox& box = boxes[cell_of_pair(i, boxes.size())];
        const bool is_on_it = box.width() == 0 ? w.given[2 * i] == box.left : w.given[2 * i + 1] == box.low;
        if (!is_on_it) return false;
    }
    return true;
}

/// Whether all cells would be right if what ends at the largest coordinate of all ended at 1.
inline bool ends_too_early(const WrongAnswer& w) {
    auto boxes = boxes_of(w);
    const double right = std::ranges::max(boxes, {}, &CellBox::right).right;
    const double high = std::ranges::max(boxes, {}, &CellBox::high).high;
    if (!(right < 1 - 1e-12 || high < 1 - 1e-12) || std::min(right, high) < 0.5) return false;
    for (CellBox& box : boxes) {
        if (box.right == right) box.right = 1;
        if (box.high == high) box.high = 1;
    }
    return !fault_of(boxes);
}

/// Whether all points are in the square or a rounding error beyond it, and some have the coordinate 1.
inline bool reaches_one(std::span<const double> answer) {
    const double largest = *std::ranges::max_element(answer);
    return all_finite(answer) && largest >= 1 && largest < 1 + 1e-12 && *std::ranges::min_element(answer) >= 0;
}

/// Whether some cells lie beyond the square's right or upper side, or were cut off there, and all others have the right
/// area.
inline bool some_are_beyond_their_row(const WrongAnswer& w) {
    const double count = w.question.input[0];
    std::size_t beyond = 0;
    for (const CellBox& box : boxes_of(w)) {
        const bool is_beyond =
            box.right > 1 + rounding || box.left > 1 - rounding || box.high > 1 + rounding || box.low > 1 - rounding;
        if (!is_beyond && std::abs(box.area() * count - 1) > 1e-6) return false;
        beyond += is_beyond;
    }
    return beyond > 0;
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"rounded_to_one", "the largest numbers give the coordinate 1", [](const WrongAnswer& w) {
             return w.question.input[1] == numbers::at_ends && reaches_one(w.given) && !fault_of(boxes_of(w));
         }});
    add({"floats", "all coordinates are numbers of a float's precision", [](const WrongAnswer& w) {
             return all_finite(w.given) && std::ranges::all_of(w.given, [](double x) {
                        return x == static_cast<double>(static_cast<float>(x));
                    });
         }});
    add({"always_one_point", "every cell has one point, whatever u and v are", [](const WrongAnswer& w) {
             return of_every_cell(w, [](const CellBox& b) { return b.width() == 0 && b.height() == 0; });
         }});
    add({"one_number", "the points of each cell lie on a line along one of its sides", on_lines_along_sides});
    add({"whole_steps", "the cells are right, and their points lie on a few lines only", [](const WrongAnswer& w) {
             return are_spread(w.question.input[1]) && all_finite(w.given) && !fault_of(boxes_of(w)) &&
                    have_whole_steps(shares_in_cells(boxes_of(w), w.given));
         }});
    add({"same_number", "all points lie on the diagonals of their cells", on_diagonals});
    add({"cell_ignored", "every cell is all of the square", [](const WrongAnswer& w) {
             return !is_single(w.question) &&
                    of_every_cell(w, [](const CellBox& b) { return std::abs(b.area() - 1) < rounding; }) &&
                    in_square(w.given);
         }});
    add({"strips", "the cells are strips as long as the square", [](const WrongAnswer& w) {
             return areas_between(w, 1 - 1e-6, 1 + 1e-6) &&
                    of_every_cell(w, [](const CellBox& b) { return std::max(b.width(), b.height()) > 1 - rounding; });
         }});
    add({"strips", "the cells are right but for their sides, of which some are longer than 2 / sqrt(count)",
         [](const WrongAnswer& w) {
             const auto fault = fault_of(boxes_of(w));
             return fault && fault->kind == CellFault::Kind::side && in_square(w.given);
         }});
    add({"rooks", "each cell is 1 / count wide and 1 / count high", [](const WrongAnswer& w) {
             const double side = 1 / w.question.input[0];
             return !is_single(w.question) && of_every_cell(w, [side](const CellBox& b) {
                 return std::abs(b.width() - side) < rounding && std::abs(b.height() - side) < rounding;
             });
         }});
    add({"cut_too_early", "the cells are right but for those at the upper sides, which end too early", ends_too_early});
    add({"counts_from_one", "no cell begins where the square does, or some lie beyond it, and all have the right area",
         [](const WrongAnswer& w) {
             return areas_between(w, 1 - 1e-6, 1 + 1e-6) && !begins_at_zero(w) && !has_twins(w) && is_whole_shift(w);
         }});
    add({"shifted", "all cells have the right area, and stand a part of a cell beside their place",
         [](const WrongAnswer& w) {
             return areas_between(w, 1 - 1e-6, 1 + 1e-6) && !begins_at_zero(w) && !has_twins(w) && !is_whole_shift(w);
         }});
    add({"overlapping", "all cells have the right area, and some lie over others", [](const WrongAnswer& w) {
             return areas_between(w, 1 - 1e-6, 1 + 1e-6) && begins_at_zero(w) && !has_twins(w) && overlap(w);
         }});
    add({"jitter_large", "the cells reach into one another", [](const WrongAnswer& w) {
             return !has_twins(w) && areas_between(w, 1.05, 1e9) && (is_single(w.question) || overlap(w));
         }});
    add({"jitter_small", "there is room between the cells",
         [](const WrongAnswer& w) { return areas_between(w, 0, 0.95) && !has_twins(w) && !begins_at_zero(w); }});
    add({"jitter_small", "there is room between the cells, and around all of them",
         [](const WrongAnswer& w) { return areas_between(w, 0, 0.95) && !has_twins(w) && in_square(w.given); },
         [](const Case&) { return true; }});
    add({"beyond_its_row", "some cells lie beyond the end of their row, and all others have the right area",
         [](const WrongAnswer& w) { return some_are_beyond_their_row(w) && begins_at_zero(w); }});
    // With a rounded root there are too few places for one count, and too many for the next.
    const auto lie_beyond = [](const WrongAnswer& w) {
        return !is_square(w.question) && !in_square(w.given) && !has_twins(w);
    };
    const auto leave_out = [](const WrongAnswer& w) {
        return !is_square(w.question) && covered(w) < 1 - 1e-6 && in_square(w.given) && !has_twins(w);
    };
    add({"only_squares", "the count is no square number, and cells lie beyond the square", lie_beyond, {}, leave_out});
    add({"empty_cells",
         "the count is no square number, and the cells leave a part of the square out",
         leave_out,
         {},
         lie_beyond});
    add({"only_squares", "the count is no square number, and there are places for the next smaller square number alone",
         [](const WrongAnswer& w) {
             const double root = std::floor(std::sqrt(static_cast<double>(count_of(w.question.input))));
             const CellBox first = boxes_of(w).front();
             return !is_square(w.question) && std::abs(first.width() * root - 1) < 1e-6 &&
                    std::abs(first.height() * root - 1) < 1e-6;
         }});
    add({"unequal_areas", "the cells cover the square, and some are larger than others", [](const WrongAnswer& w) {
             return std::abs(covered(w) - 1) < 1e-6 && in_square(w.given) && !overlap(w) &&
                    !areas_between(w, 1 - 1e-6, 1 + 1e-6) && areas_between(w, 0.01, 100);
         }});
    add({"only_squares", "the count is no square number, cells are too large, and two have the same place",
         [](const WrongAnswer& w) {
             return !is_square(w.question) && has_twins(w) && areas_between(w, 1 + 1e-6, 1e9);
         }});
    add({"row_and_column", "two cells have the same place", has_twins});
    add({"not_uniform", "the cells are right, and the points are not spread evenly in them", [](const WrongAnswer& w) {
             return are_spread(w.question.input[1]) && all_finite(w.given) && in_square(w.given) &&
                    !fault_of(boxes_of(w));
         }});
    return all;
}

}  // namespace raylab::grading::jitter
