#pragma once

#include "questions.h"
#include "symptom.h"

// How an answer stands to the right cells, and the cells that other ways lead to.

namespace raylab::grading::listing {

inline Arguments of(const Case& question) { return arguments(question.input); }
inline std::optional<CellRectangle> said(const WrongAnswer& w) { return read_cells(w.given); }
inline bool is_of(const Case& question, const std::string& group) { return question.group.starts_with(group); }

inline long double depth(const Arguments& given, std::size_t corner) {
    return seen_by(given.corners[corner], given.face).w;
}
inline bool has_corner_behind(const Case& question) {
    const auto given = of(question);
    for (std::size_t i = 0; i < given.corners.size(); ++i)
        if (depth(given, i) <= 0) return true;
    return false;
}
inline bool is_all_in_front(const Case& question) { return !has_corner_behind(question); }

/// The image of the corners, some left out, where another number stands for w.
template <class Keep, class Depth>
Window images(const Arguments& given, const Keep& keep, const Depth& depth_of) {
    Window all;
    for (const Vec3d& corner : given.corners) {
        const Seen p = seen_by(corner, given.face);
        if (!keep(p)) continue;
        const long double u = p.u / depth_of(p), v = p.v / depth_of(p);
        all = {std::min(all.left, u), std::max(all.right, u), std::min(all.low, v), std::max(all.high, v)};
    }
    return all;
}

inline bool is_within(const Seen& p) { return p.w > 0 && std::abs(p.u) <= p.w && std::abs(p.v) <= p.w; }

/// An answer is what another window gives, whether or not windows beside the face are noticed.
inline bool is_by(const WrongAnswer& w, const Window& other) {
    const auto given = of(w.question);
    const auto cells = cells_of(other, given.resolution);
    const bool is_beside = other.left > 1 || other.right < -1 || other.low > 1 || other.high < -1;
    return said(w) == cells || (is_beside && !said(w));
}

/// The four numbers, without whether there is an answer.
inline bool lacks(const WrongAnswer& w) {  // a cell that belongs to the list
    const auto expected = truth(of(w.question)), given = said(w);
    if (!expected) return false;
    return !given || given->first_column > expected->first_column || given->last_column < expected->last_column ||
           given->first_row > expected->first_row || given->last_row < expected->last_row;
}
inline bool holds_all(const WrongAnswer& w) { return said(w) && !lacks(w); }
inline bool is_whole_face(const WrongAnswer& w) {
    const int last = of(w.question).resolution - 1;
    return said(w) == CellRectangle{0, last, 0, last};
}

/// Each number that is wrong is one too large, or too small, as `ends` says: for the first and for the last.
inline bool is_off(const WrongAnswer& w, int first, int last) {
    const auto expected = truth(of(w.question)), given = said(w);
    if (!expected || !given || given == expected) return false;
    const auto fits = [](int x, int right, int by) { return x == right || x == right + by; };
    return fits(given->first_column, expected->first_column, first) &&
           fits(given->last_column, expected->last_column, last) &&
           fits(given->first_row, expected->first_row, first) && fits(given->last_row, expected->last_row, last);
}

/// Whether the last column or the last row could be one larger.
inline bool ends_before_the_edge(const Case& question) {
    const auto given = of(question);
    const auto cells = truth(given);
    return cells && (cells->last_column + 1 < given.resolution || cells->last_row + 1 < given.resolution);
}

inline CellRectangle turned(const CellRectangle& c) { return {c.first_row, c.last_row, c.first_column, c.last_column}; }

inline bool changes_places(const WrongAnswer& w) {
    const auto expected = truth(of(w.question));
    return expected && said(w) == turned(*expected);
}

/// On the same face columns and rows count from the other end.
inline bool is_mirrored(const WrongAnswer& w) {
    const auto expected = truth(of(w.question)), given = said(w);
    if (!expected || !given) return false;
    const int last = of(w.question).resolution - 1;
    const auto is = [&](int first, int end, int right_first, int right_end) {
        return first == last - right_end && end == last - right_first;
    };
    return is(given->first_column, given->last_column, expected->first_column, expected->last_column) &&
           is(given->first_row, given->last_row, expected->first_row, expected->last_row);
}

/// Columns, or rows, count from the other end, and the others are right.
inline bool is_mirrored_one_way(const WrongAnswer& w, bool is_of_columns) {
    const auto expected = truth(of(w.question)), given = said(w);
    if (!expected || !given) return false;
    const int last = of(w.question).resolution - 1;
    CellRectangle other = *expected;
    if (is_of_columns)
        other.first_column = last - expected->last_column, other.last_column = last - expected->first_column;
    else
        other.first_row = last - expected->last_row, other.last_row = last - expected->first_row;
    return given == other;
}

inline Arguments of_first_corners(Arguments given, std::size_t most) {
    given.corners.resize(std::min(most, given.corners.size()));
    return given;
}

inline bool is_negative(const Case& question) { return of(question).face % 2 == 1; }

/// Whether counting from the other end makes a difference.
inline bool is_lopsided(const Case& question) {
    const auto given = of(question);
    const auto cells = truth(given);
    const int last = given.resolution - 1;
    return cells && (cells->first_column + cells->last_column != last || cells->first_row + cells->last_row != last);
}

/// The cells of what is seen where a place x from -1 to 1 is put at factor x + offset of the face, and not at (x + 1)
/// / 2.
inline bool is_counted_by(const WrongAnswer& w, long double factor, long double offset) {
    const auto given = of(w.question);
    const auto seen = said(w);
    const Window right = window(given);
    if (!seen || right.is_empty()) return false;
    const auto at = [&](long double x) { return (factor * x + offset) * given.resolution; };
    const auto is = [&](int cell, long double number) {
        return cell == number || cell == std::clamp(number, 0.0L, given.resolution - 1.0L);
    };
    const auto fits = [&](int first, int last, long double low, long double high) {
        return (is(first, std::ceil(at(low)) - 1) || is(first, std::floor(at(low)))) && is(last, std::floor(at(high)));
    };
    return fits(seen->first_column, seen->last_column, right.left, right.right) &&
           fits(seen->first_row, seen->last_row, right.low, right.high);
}

/// Points at which a cell is asked for the polygon.
enum class Asked { middle, corners, both };

/// The rectangle about those cells alone that show the polygon at one of these points.
inline std::optional<CellRectangle> cells_by_points(const Arguments& given, Asked asked) {
    std::optional<CellRectangle> cells;
    const auto is_seen = [&](double column, double row) {
        return is_seen_at(given, 2 * column / given.resolution - 1, 2 * row / given.resolution - 1);
    };
    for (int row = 0; row < given.resolution; ++row)
        for (int column = 0; column < given.resolution; ++column) {
            const bool by_middle = asked != Asked::corners && is_seen(column + 0.5, row + 0.5);
            const bool by_corner = asked != Asked::middle && (is_seen(column, row) || is_seen(column + 1, row) ||
                                                              is_seen(column, row + 1) || is_seen(column + 1, row + 1));
            if (!by_middle && !by_corner) continue;
            if (!cells) cells = CellRectangle{column, column, row, row};
            cells = CellRectangle{std::min(cells->first_column, column), std::max(cells->last_column, column),
                                  std::min(cells->first_row, row), std::max(cells->last_row, row)};
        }
    return cells;
}

inline bool names_no_cell(const WrongAnswer& w) {
    const auto given = said(w);
    const int n = of(w.question).resolution;
    if (!given) return false;
    return given->first_column < 0 || given->first_row < 0 || given->last_column >= n || given->last_row >= n ||
           given->first_column > given->last_column || given->first_row > given->last_row;
}

/// What is seen of the polygon has a corner of it that lies on the face.
inline bool shows_no_corner(const Case& question) {
    const auto given = of(question);
    return images(given, is_within, [](const Seen& p) { return p.w; }).is_empty();
}

}  // namespace raylab::grading::listing
