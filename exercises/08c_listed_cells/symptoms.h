#pragma once

#include "questions.h"
#include "symptom.h"

// What wrong answers to this exercise have in common.

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

/// The rectangle about those cells alone whose middle shows the polygon.
inline std::optional<CellRectangle> cells_by_their_middles(const Arguments& given) {
    std::optional<CellRectangle> cells;
    for (int row = 0; row < given.resolution; ++row)
        for (int column = 0; column < given.resolution; ++column) {
            const auto middle = [&](int i) { return (2 * i + 1.0) / given.resolution - 1; };
            if (!is_seen_at(given, middle(column), middle(row))) continue;
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

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    const auto everything = [](const Seen&) { return true; };
    const auto by_depth = [](const Seen& p) { return p.w; };
    add({"no_such_cell", "you name a cell that is not on the face", [](const WrongAnswer& w) {
             const auto given = said(w);
             if (!names_no_cell(w)) return false;
             const int n = of(w.question).resolution;
             const auto cut = [&](int x) { return std::clamp(x, 0, n - 1); };
             return CellRectangle{cut(given->first_column), cut(given->last_column), cut(given->first_row),
                                  cut(given->last_row)} == truth(of(w.question));
         }});
    add({"order_of_axes", "the face is +y or -y, and columns and rows have changed places",
         [](const WrongAnswer& w) { return of(w.question).face / 2 == 1 && changes_places(w); }});
    add({"swapped", "columns and rows have changed places", changes_places});
    add({"negative_faces", "the face is a negative one", [](const WrongAnswer& w) { return is_negative(w.question); },
         [](const Case& q) { return is_negative(q) && is_lopsided(q); }});
    add({"mirrored", "columns and rows count from the other end", is_mirrored});
    add({"touch", "the polygon touches the face in an edge, and you list no cell",
         [](const WrongAnswer& w) { return is_of(w.question, "up to the edge") && !said(w); }});
    add({"border", "the polygon ends exactly in the border of a cell, and you leave out one beyond it",
         [](const WrongAnswer& w) { return is_of(w.question, "up to the") && lacks(w); }});
    add({"behind_too", "all of the polygon is behind the light, and you list cells of this face",
         [](const WrongAnswer& w) {
             const auto given = of(w.question);
             return said(w) &&
                    std::ranges::all_of(given.corners, [&](const Vec3d& p) { return seen_by(p, given.face).w < 0; });
         }});
    add({"whole_face", "the polygon has corners behind the light, and you list the whole face",
         [](const WrongAnswer& w) { return has_corner_behind(w.question) && is_whole_face(w); }});
    add({"lost_behind", "the polygon has corners behind the light, and you list no cell",
         [](const WrongAnswer& w) { return has_corner_behind(w.question) && !said(w); },
         [](const Case& q) { return has_corner_behind(q) && truth(of(q)).has_value(); }});
    add({"cut_edges", "the cells are those of the corners in front of the light, without those behind it",
         [by_depth](const WrongAnswer& w) {
             return has_corner_behind(w.question) &&
                    is_by(w, images(
                                 of(w.question), [](const Seen& p) { return p.w > 0; }, by_depth));
         }});
    add({"thrown_over", "corners behind the light are divided by their negative w", [=](const WrongAnswer& w) {
             return has_corner_behind(w.question) && is_by(w, images(of(w.question), everything, by_depth));
         }});
    add({"thrown_over", "corners behind the light are divided by the size of their w", [=](const WrongAnswer& w) {
             return has_corner_behind(w.question) &&
                    is_by(w, images(of(w.question), everything, [](const Seen& p) { return std::abs(p.w); }));
         }});
    add({"no_corner_seen", "the cells are those of the corners on the face, without the others",
         [=](const WrongAnswer& w) { return is_by(w, images(of(w.question), is_within, by_depth)); }});
    add({"no_corner_seen", "no corner of the polygon is seen through the face, and you list no cell",
         [](const WrongAnswer& w) { return shows_no_corner(w.question) && !said(w); },
         [](const Case& q) { return shows_no_corner(q) && truth(of(q)).has_value(); }});
    add({"cut_first", "all corners are in front of the light, and the rectangle is about what is beyond the face, too",
         [=](const WrongAnswer& w) {
             return is_all_in_front(w.question) && is_by(w, images(of(w.question), everything, by_depth));
         }});
    add({"not_divided", "u and v are not divided by w", [=](const WrongAnswer& w) {
             return is_by(w, images(of(w.question), everything, [](const Seen&) { return 1; })) ||
                    is_by(w, images(
                                 of(w.question), [](const Seen& p) { return p.w > 0; }, [](const Seen&) { return 1; }));
         }});
    add({"last_included", "the last column and the last row are one too large",
         [](const WrongAnswer& w) { return is_off(w, 0, 1); }, [](const Case& q) { return truth(of(q)).has_value(); }});
    add({"last_included", "the last column and the last row are one too large, but for the edges of the face",
         [](const WrongAnswer& w) { return is_off(w, 0, 1); },
         [](const Case& q) { return ends_before_the_edge(q) && !is_of(q, "up to"); },
         [](const WrongAnswer& w) { return is_off(w, 0, 1); }});
    add({"too_wide", "the rectangle is a cell too wide on both sides, but for the edges of the face",
         [](const WrongAnswer& w) { return holds_all(w) && is_off(w, -1, 1); },
         [](const Case& q) { return ends_before_the_edge(q) && !is_of(q, "up to"); },
         [](const WrongAnswer& w) { return holds_all(w) && is_off(w, -1, 1); }});
    add({"centers", "first ones are one too large, or last ones one too small",
         [](const WrongAnswer& w) { return lacks(w) && is_off(w, 1, -1); }});
    add({"centers", "the cells are those whose middle shows the polygon",
         [](const WrongAnswer& w) { return said(w) == cells_by_their_middles(of(w.question)); }});
    add({"range", "the place from -1 to 1 is taken for one from 0 to 1",
         [](const WrongAnswer& w) { return is_counted_by(w, 1, 0); }});
    add({"range", "the place is not halved", [](const WrongAnswer& w) { return is_counted_by(w, 1, 1); }});
    add({"range", "the place is halved, and 1 is not added before",
         [](const WrongAnswer& w) { return is_counted_by(w, 0.5L, 0); }});
    add({"cut_first", "the polygon reaches beyond the face, nothing is missing, and you list more than is seen",
         [](const WrongAnswer& w) {
             return is_all_in_front(w.question) && !is_within_the_face(of(w.question)) && holds_all(w);
         }});
    add({"cut_edges", "the polygon reaches behind the light, and cells are missing",
         [](const WrongAnswer& w) { return has_corner_behind(w.question) && said(w) && lacks(w); }});
    add({"partly_seen", "a part of the polygon is not on the face",
         [](const WrongAnswer& w) { return !is_within_the_face(of(w.question)); }});
    return all;
}

}  // namespace raylab::grading::listing
