#pragma once

#include "other_cuts.h"

#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::listing {

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
    for (const bool is_of_columns : {true, false})
        add({"mirrored", is_of_columns ? "columns count from the other end" : "rows count from the other end",
             [is_of_columns](const WrongAnswer& w) { return is_mirrored_one_way(w, is_of_columns); }});
    for (const std::size_t most : {std::size_t{3}, std::size_t{4}})
        add({"three_to_five", "the cells are those of the polygon's first corners, without the others",
             [most](const WrongAnswer& w) {
                 const auto given = of(w.question);
                 return given.corners.size() > most && said(w) == truth(of_first_corners(given, most));
             },
             [most](const Case& q) {
                 const auto given = of(q);
                 return given.corners.size() > most && truth(of_first_corners(given, most)) != truth(given);
             }});
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
    add_cuts(all);
    add({"centers", "first ones are one too large, or last ones one too small",
         [](const WrongAnswer& w) { return lacks(w) && is_off(w, 1, -1); }});
    const auto by_points = [&](const std::string& words, Asked asked) {
        add({"centers", words,
             [asked](const WrongAnswer& w) { return said(w) == cells_by_points(of(w.question), asked); }});
    };
    by_points("the cells are those whose middle shows the polygon", Asked::middle);
    by_points("the cells are those of which a corner shows the polygon", Asked::corners);
    by_points("the cells are those whose middle, or a corner of which, shows the polygon", Asked::both);
    add({"one_cell_fewer", "the cells are those of a face that is cut into resolution - 1",
         [](const WrongAnswer& w) {
             const auto given = of(w.question);
             return said(w) == cells_of(window(given), given.resolution - 1, given.resolution);
         },
         [](const Case& q) {
             const auto given = of(q);
             return given.resolution > 1 &&
                    cells_of(window(given), given.resolution - 1, given.resolution) != truth(given);
         }});
    add({"more_corners", "the polygon has more than five corners while it is cut, and cells are missing",
         [](const WrongAnswer& w) { return lacks(w) && corners_while_cut(of(w.question)) > 5; }});
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
    return of_numbers(std::move(all));
}

}  // namespace raylab::grading::listing
