#pragma once

#include "symptom.h"
#include "truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::cells {

inline bool same_face(const WrongAnswer& w) { return w.right[0] == w.given[0]; }
inline double resolution_of(const WrongAnswer& w) { return w.question.input[3]; }
inline Vec3d direction_of(const Case& question) { return arguments(question.input).direction; }
inline int axis_of(const WrongAnswer& w) { return static_cast<int>(w.right[0]) / 2; }

/// What is seen through the right face, as two places from -1 to 1.
struct Places {
    double u, v;
};
inline Places places(const WrongAnswer& w) {
    const Seen seen = seen_through(direction_of(w.question), static_cast<int>(w.right[0]));
    return {static_cast<double>(seen.u / seen.w), static_cast<double>(seen.v / seen.w)};
}

/// On the right face, column and row are these of the two places, wherever those are not the right ones.
inline Symptom counted(const std::string& hint, const std::string& words,
                       double (*number)(const WrongAnswer& w, double place)) {
    const auto cut = [](const WrongAnswer& w, double x) { return std::clamp(x, 0.0, resolution_of(w) - 1); };
    return {hint, words,
            [=](const WrongAnswer& w) {
                const auto [u, v] = places(w);
                const auto is = [&](double given, double place) {
                    const double x = number(w, place);
                    return given == x || given == cut(w, x);
                };
                return same_face(w) && is(w.given[1], u) && is(w.given[2], v);
            },
            [=](const Case& question) {
                const std::array<double, 3> face{1.0 * found_face(direction_of(question)), 0, 0};
                const WrongAnswer w{question, face, face};
                const auto [u, v] = places(w);
                const auto is_another = [&](double place) {
                    return cut(w, number(w, place)) != cut(w, std::floor((place + 1) / 2 * resolution_of(w)));
                };
                return is_another(u) || is_another(v);
            }};
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    const auto swaps = [](const WrongAnswer& w) {
        return same_face(w) && w.given[1] == w.right[2] && w.given[2] == w.right[1];
    };
    add({"borders_below", "the place is exactly at a border, the near edge of the face, and the number is -1",
         [](const WrongAnswer& w) {
             const auto is_before = [&](std::size_t i) { return w.given[i] == -1; };
             return same_face(w) && (is_before(1) || is_before(2)) && (w.given[1] == w.right[1] || is_before(1)) &&
                    (w.given[2] == w.right[2] || is_before(2));
         }});
    add({"no_such_cell", "the cell's number is `resolution`, or -1: there is none", [](const WrongAnswer& w) {
             const auto is_beyond = [&](std::size_t i) { return w.given[i] == resolution_of(w) || w.given[i] == -1; };
             return same_face(w) && (is_beyond(1) || is_beyond(2)) && (w.given[1] == w.right[1] || is_beyond(1)) &&
                    (w.given[2] == w.right[2] || is_beyond(2));
         }});
    add({"order_of_axes", "on the faces +y and -y column and row have changed places",
         [swaps](const WrongAnswer& w) { return swaps(w) && axis_of(w) == 1; }});
    add({"order_of_axes", "on the faces of one axis column and row have changed places",
         [swaps](const WrongAnswer& w) { return swaps(w) && axis_of(w) == 0; }});
    add({"order_of_axes", "on the faces of one axis column and row have changed places",
         [swaps](const WrongAnswer& w) { return swaps(w) && axis_of(w) == 2; }});
    add({"swapped", "column and row have changed places", swaps});
    const auto loses_sign = [](const WrongAnswer& w, bool of_column, bool of_row) {
        const auto [u, v] = places(w);
        const auto cell = [&](double place, bool is_lost) {
            const double x = std::floor(((is_lost ? std::abs(place) : place) + 1) / 2 * resolution_of(w));
            return std::clamp(x, 0.0, resolution_of(w) - 1);
        };
        return same_face(w) && resolution_of(w) > 1 && w.given[1] == cell(u, of_column) &&
               w.given[2] == cell(v, of_row);
    };
    // Mirrored are the negative places alone.
    for (const auto& [of_column, of_row] : {std::pair{true, true}, std::pair{true, false}, std::pair{false, true}})
        add({"sign_lost", "a negative place is counted as if it were positive",
             [loses_sign, of_column, of_row](const WrongAnswer& w) { return loses_sign(w, of_column, of_row); }});
    add({"signed_depth", "on the negative faces columns and rows count from the other side", [](const WrongAnswer& w) {
             const double last = resolution_of(w) - 1;
             const auto mirrored = [&](std::size_t i) { return std::abs(w.given[i] - (last - w.right[i])) <= 1; };
             return same_face(w) && static_cast<int>(w.right[0]) % 2 == 1 && mirrored(1) && mirrored(2);
         }});
    add({"one_side_mirrored", "a column or a row counts from the other side", [](const WrongAnswer& w) {
             const double last = resolution_of(w) - 1;
             const auto fits = [&](std::size_t i) {
                 return w.given[i] == w.right[i] || std::abs(w.given[i] - (last - w.right[i])) <= 1;
             };
             return same_face(w) && resolution_of(w) > 4 && fits(1) && fits(2);
         }});
    add({"other_layout",
         "column and row are those of the face's two axes, in another order or from another side",
         [](const WrongAnswer& w) {
             const double last = resolution_of(w) - 1;
             const auto is = [&](double given, double right) {
                 return given == right || std::abs(given - (last - right)) <= 1;
             };
             const auto fits = [&](double column, double row) { return is(w.given[1], column) && is(w.given[2], row); };
             return same_face(w) && resolution_of(w) > 4 &&
                    (fits(w.right[1], w.right[2]) || fits(w.right[2], w.right[1]));
         },
         {},
         [](const WrongAnswer& w) { return same_face(w) && resolution_of(w) <= 4; }});
    add({"sign_aside", "the face is that of the largest coordinate with its sign, or one that it is not",
         [](const WrongAnswer& w) {
             const Vec3d d = direction_of(w.question);
             const double largest = std::max({d.x, d.y, d.z});
             return static_cast<int>(w.right[0]) % 2 == 1 && w.given[0] >= 0 && w.given[0] < 6 &&
                    d[static_cast<int>(w.given[0]) / 2] == largest;
         }});
    add({"wrong_side", "the face is the one across the cube", [](const WrongAnswer& w) {
             return std::floor(w.given[0] / 2) == std::floor(w.right[0] / 2) && !same_face(w);
         }});
    add({"numbers_of_faces", "the faces are numbered in another order, column and row are right",
         [](const WrongAnswer& w) { return !same_face(w) && w.given[1] == w.right[1] && w.given[2] == w.right[2]; }});
    add({"largest_of_three",
         "the face is that of a coordinate which is not the largest, sign aside, though its sign is right",
         [](const WrongAnswer& w) {
             const Vec3d d = direction_of(w.question);
             if (!(w.given[0] >= 0 && w.given[0] < 6)) return false;
             const int face = static_cast<int>(w.given[0]);
             const double coordinate = d[face / 2] * (face % 2 == 0 ? 1 : -1);
             return coordinate > 0 && coordinate < std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
         }});
    add({"few_digits", "the place is within a thousandth of a cell of a border, and you give the cell beyond it",
         [](const WrongAnswer& w) {
             const auto [u, v] = places(w);
             const auto is_beyond = [&](double given, double place) {
                 const double at = (place + 1) / 2 * resolution_of(w), border = std::round(at);
                 return std::abs(at - border) < 1e-3 && given == (at < border ? border : border - 1);
             };
             const auto fits = [&](std::size_t i, double place) {
                 return w.given[i] == w.right[i] || is_beyond(w.given[i], place);
             };
             return same_face(w) && fits(1, u) && fits(2, v);
         }});
    add(counted("equal_angles", "the cells divide the face's right angle into equal angles",
                [](const WrongAnswer& w, double place) {
                    return std::floor((std::atan(place) / std::atan(1.0) + 1) / 2 * resolution_of(w));
                }));
    add(counted("rounded", "the number is rounded to the nearest, not down",
                [](const WrongAnswer& w, double place) { return std::round((place + 1) / 2 * resolution_of(w)); }));
    add(counted(
        "rounded", "the number is rounded to the nearest of 0 to resolution - 1",
        [](const WrongAnswer& w, double place) { return std::round((place + 1) / 2 * (resolution_of(w) - 1)); }));
    add(counted("last_number", "the place is multiplied by resolution - 1", [](const WrongAnswer& w, double place) {
        return std::floor((place + 1) / 2 * (resolution_of(w) - 1));
    }));
    add(counted("range", "the place is moved by a half, and not halved",
                [](const WrongAnswer& w, double place) { return std::floor((place + 0.5) * resolution_of(w)); }));
    add(counted("range", "the number is halved and moved by a half of one cell",
                [](const WrongAnswer& w, double place) { return std::trunc(place / 2 * resolution_of(w) + 0.5); }));
    add(counted("half_of_odd", "half of the resolution is taken in whole numbers",
                [](const WrongAnswer& w, double place) {
                    const double half = std::floor(resolution_of(w) / 2);
                    return half + std::floor(place * half);
                }));
    add(counted("half_of_odd", "half of the resolution is taken in whole numbers",
                [](const WrongAnswer& w, double place) {
                    const double half = std::floor(resolution_of(w) / 2);
                    return std::floor((place + 1) * half);
                }));
    add(counted("range", "the place is not brought from -1..1 to 0..1",
                [](const WrongAnswer& w, double place) { return std::floor(place * resolution_of(w)); }));
    add(counted("range", "the place is not brought from -1..1 to 0..1",
                [](const WrongAnswer& w, double place) { return std::trunc(place * resolution_of(w)); }));
    add(counted("range", "the place is halved wrongly",
                [](const WrongAnswer& w, double place) { return std::floor((place + 1) * resolution_of(w)); }));
    add(counted("towards_zero", "a negative number is cut towards zero", [](const WrongAnswer& w, double place) {
        return std::trunc(place * resolution_of(w) / 2) + std::floor(resolution_of(w) / 2);
    }));
    add(counted("towards_zero", "a negative number is cut towards zero, and 0 to 2 resolution halved after that",
                [](const WrongAnswer& w, double place) {
                    return std::trunc((std::trunc(place * resolution_of(w)) + resolution_of(w)) / 2);
                }));
    add({"ball_not_cube", "the place is the one on a ball: divided by the length", [](const WrongAnswer& w) {
             const auto given = arguments(w.question.input);
             const Seen seen = seen_through(given.direction, static_cast<int>(w.right[0]));
             const double length = glm::length(given.direction);
             const auto is = [&](double number, long double u) {
                 return std::abs(number - std::floor((static_cast<double>(u) / length + 1) / 2 * given.resolution)) <
                        0.5;
             };
             return same_face(w) && is(w.given[1], seen.u) && is(w.given[2], seen.v);
         }});
    add({"cut_too_early", "the direction goes through the last cells, and your number is up to a hundredth smaller",
         [](const WrongAnswer& w) {
             const double last = resolution_of(w) - 1;
             const auto is_less = [&](std::size_t i) {
                 return w.right[i] > 0.98 * last && w.given[i] < w.right[i] && w.given[i] > 0.98 * w.right[i] - 1;
             };
             const auto fits = [&](std::size_t i) { return w.given[i] == w.right[i] || is_less(i); };
             return same_face(w) && resolution_of(w) > 100 && fits(1) && fits(2);
         }});
    add(counted("not_divided", "the coordinates count as they come, whatever the largest one is",
                [](const WrongAnswer& w, double place) {
                    const Vec3d d = direction_of(w.question);
                    const double size = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
                    return std::floor((place * size + 1) / 2 * resolution_of(w));
                }));
    add({"zero_over_zero", "a coordinate is 0",
         [](const WrongAnswer& w) {
             const Vec3d d = direction_of(w.question);
             return d.x == 0 || d.y == 0 || d.z == 0;
         },
         [](const Case& q) {
             const Vec3d d = direction_of(q);
             return d.x == 0 || d.y == 0 || d.z == 0;
         }});
    const auto size_of = [](const Case& q) {
        const Vec3d d = direction_of(q);
        return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    };
    add({"not_divided", "the largest coordinate is not of size 1",
         [size_of](const WrongAnswer& w) { return size_of(w.question) != 1; },
         [size_of](const Case& q) { return q.input[3] > 4 && (size_of(q) > 2 || size_of(q) < 0.5); },
         [size_of](const WrongAnswer& w) { return size_of(w.question) != 1; }});
    return of_numbers(std::move(all), {"zero_over_zero"});
}

}  // namespace raylab::grading::cells
