#pragma once

#include "arguments.h"
#include "symptom.h"

#include <cmath>
#include <functional>
#include <utility>

// What wrong answers to this exercise have in common.

namespace raylab::grading::picture_rays {

inline double across(double x, double pixels) { return 2 * x / pixels - 1; }

inline bool is_orthographic(const Case& question) { return question.input[14] != 0; }
inline bool is_square(const Case& question) { return question.input[15] == question.input[16]; }

inline Vec3d origin_in(std::span<const double> answer) { return {answer[0], answer[1], answer[2]}; }
inline Vec3d direction_in(std::span<const double> answer) { return {answer[3], answer[4], answer[5]}; }

inline bool close(const Vec3d& a, const Vec3d& b) { return glm::length(a - b) <= 1e-7 * std::max(1.0, glm::length(b)); }

inline Vec3d at(const Arguments& g, double right, double up) { return right * g.frame.right + up * g.frame.up; }

inline Vec3d right_place(const Arguments& g) {
    return at(g, across(g.x, g.frame.image.width) * g.frame.half_width,
              -across(g.y, g.frame.image.height) * g.frame.half_height);
}

/// Where each of the two steps ends in a unit vector, the second one is too long. (In perspective: orthographic rays
/// have no such steps.)
inline Vec3d after_a_unit_step(const Arguments& g, bool right_first) {
    const double right = across(g.x, g.frame.image.width) * g.frame.half_width,
                 up = -across(g.y, g.frame.image.height) * g.frame.half_height;
    if (g.frame.projection == CameraFrame::Projection::orthographic) return at(g, right, up);
    return right_first ? at(g, right, up * std::hypot(1, right)) : at(g, right * std::hypot(1, up), up);
}

/// The point whose steps are these numbers of the half sizes: to(place, half size), the place from -1 to 1. In
/// perspective only, or with every camera, as where both have their step from one and the same line.
using Step = double (*)(double place, double half);
inline Vec3d by_steps(const Arguments& g, Step to, bool everywhere) {
    if (!everywhere && g.frame.projection == CameraFrame::Projection::orthographic) return right_place(g);
    return at(g, to(across(g.x, g.frame.image.width), g.frame.half_width),
              to(-across(g.y, g.frame.image.height), g.frame.half_height));
}

/// As on a ball about the eye: two turns, of which the first one makes the second one's circle smaller.
inline Vec3d after_two_turns(const Arguments& g, bool right_first) {
    if (g.frame.projection == CameraFrame::Projection::orthographic) return right_place(g);
    const double right = across(g.x, g.frame.image.width) * std::atan(g.frame.half_width),
                 up = -across(g.y, g.frame.image.height) * std::atan(g.frame.half_height);
    return right_first ? at(g, std::tan(right), std::tan(up) / std::cos(right))
                       : at(g, std::tan(right) / std::cos(up), std::tan(up));
}

/// The ray through this point of the picture, instead of the right one. Where the two are one point, such a ray says
/// nothing of how a wrong answer came about.
inline Symptom through(const std::string& hint, const std::string& words,
                       const std::function<Vec3d(const Arguments&)>& aside) {
    const auto goes_through = [aside](const WrongAnswer& w) {
        const auto given = arguments(w.question.input);
        const Vec3d off = aside(given);
        if (is_orthographic(w.question)) return close(origin_in(w.given), given.frame.eye + off);
        const Vec3d way = glm::normalize(direction_in(w.given));
        return close(way, glm::normalize(given.frame.forward + off));
    };
    const auto is_another = [aside](const Case& question) {
        const auto given = arguments(question.input);
        return !close(aside(given), right_place(given));
    };
    return {hint,
            words,
            [=](const WrongAnswer& w) { return is_another(w.question) && goes_through(w); },
            {},
            [=](const WrongAnswer& w) { return !is_another(w.question) && goes_through(w); }};
}

inline std::vector<Symptom> symptoms() {
    std::vector<Symptom> all;
    const auto add = [&](Symptom symptom) { all.push_back(std::move(symptom)); };
    add({"not_unit", "the direction is right and its length is not", [](const WrongAnswer& w) {
             const Vec3d d = direction_in(w.given);
             return glm::length(d) > 0 && close(glm::normalize(d), direction_in(w.right)) &&
                    !close(d, direction_in(w.right));
         }});
    // Those that look backward are parallel, too.
    add({"always_perspective", "the camera is orthographic, and your rays spread",
         [](const WrongAnswer& w) {
             const Vec3d way = glm::normalize(direction_in(w.given)), right = direction_in(w.right);
             return is_orthographic(w.question) && !close(way, right) && !close(way, -right);
         },
         [](const Case& q) { return is_orthographic(q); }});
    add({"orthographic_origin", "the camera is orthographic, and your rays begin at another point",
         [](const WrongAnswer& w) {
             return is_orthographic(w.question) && !close(origin_in(w.given), origin_in(w.right));
         },
         [](const Case& q) { return is_orthographic(q); }});
    const auto is_perspective = [](const Case& q) { return !is_orthographic(q); };
    add({"starts_at_the_picture", "the direction is right, and the ray begins on its way, not at the eye",
         [](const WrongAnswer& w) {
             const Vec3d begun = origin_in(w.given) - origin_in(w.right), way = direction_in(w.right);
             return !is_orthographic(w.question) && close(direction_in(w.given), way) && !close(begun, {0, 0, 0}) &&
                    close(begun, dot(begun, way) * way);
         },
         is_perspective, [](const WrongAnswer& w) { return is_orthographic(w.question); }});
    add({"point_as_direction", "the direction has the eye's position added to it", [](const WrongAnswer& w) {
             const auto g = arguments(w.question.input);
             const Vec3d d = direction_in(w.given), right = direction_in(w.right);
             const Vec3d mixed = g.frame.eye + right / dot(right, g.frame.forward);
             return !is_orthographic(w.question) && !close(d, right) && close(glm::normalize(d), glm::normalize(mixed));
         }});
    add({"point_as_direction", "the direction has the eye's position taken from it", [](const WrongAnswer& w) {
             const auto g = arguments(w.question.input);
             const Vec3d d = direction_in(w.given), right = direction_in(w.right);
             const Vec3d mixed = right / dot(right, g.frame.forward) - g.frame.eye;
             return !is_orthographic(w.question) && !close(d, right) && close(glm::normalize(d), glm::normalize(mixed));
         }});
    const auto shows = [&](const std::string& hint, const std::string& words, auto aside) {
        add(through(hint, words, aside));
    };
    shows("upside_down", "the ray goes through the point as far below the middle as it should be above",
          [](const Arguments& g) {
              return at(g, across(g.x, g.frame.image.width) * g.frame.half_width,
                        across(g.y, g.frame.image.height) * g.frame.half_height);
          });
    shows("mirrored", "the ray goes through the point as far to the left as it should be to the right",
          [](const Arguments& g) {
              return at(g, -across(g.x, g.frame.image.width) * g.frame.half_width,
                        -across(g.y, g.frame.image.height) * g.frame.half_height);
          });
    shows("mirrored", "the ray goes through the opposite point of the picture", [](const Arguments& g) {
        return at(g, -across(g.x, g.frame.image.width) * g.frame.half_width,
                  across(g.y, g.frame.image.height) * g.frame.half_height);
    });
    shows("half_pixel_twice", "the ray goes through the point half a pixel on", [](const Arguments& g) {
        return at(g, across(g.x + 0.5, g.frame.image.width) * g.frame.half_width,
                  -across(g.y + 0.5, g.frame.image.height) * g.frame.half_height);
    });
    shows("half_pixel_twice", "the ray goes through the point half a pixel before", [](const Arguments& g) {
        return at(g, across(g.x - 0.5, g.frame.image.width) * g.frame.half_width,
                  -across(g.y - 0.5, g.frame.image.height) * g.frame.half_height);
    });
    shows("whole_pixels", "the ray goes through the pixels' nearest corner", [](const Arguments& g) {
        return at(g, across(std::round(g.x), g.frame.image.width) * g.frame.half_width,
                  -across(std::round(g.y), g.frame.image.height) * g.frame.half_height);
    });
    shows("whole_pixels", "the ray goes through the pixel's corner", [](const Arguments& g) {
        return at(g, across(std::floor(g.x), g.frame.image.width) * g.frame.half_width,
                  -across(std::floor(g.y), g.frame.image.height) * g.frame.half_height);
    });
    shows("whole_pixels", "the ray goes through the pixel's centre", [](const Arguments& g) {
        return at(g, across(std::floor(g.x) + 0.5, g.frame.image.width) * g.frame.half_width,
                  -across(std::floor(g.y) + 0.5, g.frame.image.height) * g.frame.half_height);
    });
    shows("last_pixel_at_the_edge", "the picture is one pixel smaller than it should be", [](const Arguments& g) {
        return at(g, across(g.x, g.frame.image.width - 1) * g.frame.half_width,
                  -across(g.y, g.frame.image.height - 1) * g.frame.half_height);
    });
    shows("row_from_the_bottom", "the ray goes through the point one pixel lower: y is turned round as a row's number",
          [](const Arguments& g) {
              return at(g, across(g.x, g.frame.image.width) * g.frame.half_width,
                        across(g.frame.image.height - 1 - g.y, g.frame.image.height) * g.frame.half_height);
          });
    shows("unit_in_between", "the step upward is too large, as if the step to the right had been made unit before it",
          [](const Arguments& g) { return after_a_unit_step(g, true); });
    shows("unit_in_between", "the step to the right is too large, as if the step upward had been made unit before it",
          [](const Arguments& g) { return after_a_unit_step(g, false); });
    shows("whole_numbers", "width or height is halved in whole numbers", [](const Arguments& g) {
        const auto [width, height] = g.frame.image;
        return at(g, (g.x - width / 2) * 2 / width * g.frame.half_width,
                  (height / 2 - g.y) * 2 / height * g.frame.half_height);
    });
    shows("whole_numbers", "width or height is halved in whole numbers", [](const Arguments& g) {
        const auto [width, height] = g.frame.image;
        return at(g, (g.x / (width / 2) - 1) * g.frame.half_width, (1 - g.y / (height / 2)) * g.frame.half_height);
    });
    shows("whole_numbers", "width / height is taken in whole numbers", [](const Arguments& g) {
        const auto [width, height] = g.frame.image;
        return at(g, across(g.x, width) * (width / height) * g.frame.half_height,
                  -across(g.y, height) * g.frame.half_height);
    });
    shows("aspect_forgotten", "the ray is right but for its step to the right, which has half_height",
          [](const Arguments& g) {
              return at(g, across(g.x, g.frame.image.width) * g.frame.half_height,
                        -across(g.y, g.frame.image.height) * g.frame.half_height);
          });
    shows("aspect_forgotten", "the ray is right but for its step upward, which has half_width", [](const Arguments& g) {
        return at(g, across(g.x, g.frame.image.width) * g.frame.half_width,
                  -across(g.y, g.frame.image.height) * g.frame.half_width);
    });
    shows("aspect_forgotten", "half_width and half_height have changed places", [](const Arguments& g) {
        return at(g, across(g.x, g.frame.image.width) * g.frame.half_height,
                  -across(g.y, g.frame.image.height) * g.frame.half_width);
    });
    shows("aspect_forgotten", "the step to the right is half_height times height / width", [](const Arguments& g) {
        const auto [width, height] = g.frame.image;
        return at(g, across(g.x, width) * g.frame.half_height * height / width,
                  -across(g.y, height) * g.frame.half_height);
    });
    for (const bool everywhere : {false, true}) {
        shows("half_sizes_missing", "the steps go from -1 to 1, whatever the half sizes are", [=](const Arguments& g) {
            return by_steps(
                g, [](double place, double) { return place; }, everywhere);
        });
        shows("half_sizes_missing", "the steps go from -1 to 1, and to the right to width / height",
              [=](const Arguments& g) {
                  const auto [width, height] = g.frame.image;
                  if (!everywhere && g.frame.projection == CameraFrame::Projection::orthographic) return right_place(g);
                  return at(g, across(g.x, width) * width / height, -across(g.y, height));
              });
    }
    shows("middle_forgotten", "the picture's corner, not its middle, lies straight ahead", [](const Arguments& g) {
        return at(g, g.x / g.frame.image.width * g.frame.half_width, -g.y / g.frame.image.height * g.frame.half_height);
    });
    shows("middle_forgotten", "the picture reaches only half as far from its middle", [](const Arguments& g) {
        return at(g, (g.x / g.frame.image.width - 0.5) * g.frame.half_width,
                  (0.5 - g.y / g.frame.image.height) * g.frame.half_height);
    });
    shows("middle_forgotten", "the picture is twice as large", [](const Arguments& g) {
        return at(g, 2 * across(g.x, g.frame.image.width) * g.frame.half_width,
                  -2 * across(g.y, g.frame.image.height) * g.frame.half_height);
    });
    shows("swapped_x_and_y", "x goes upward and y to the right", [](const Arguments& g) {
        return at(g, across(g.y, g.frame.image.height) * g.frame.half_width,
                  -across(g.x, g.frame.image.width) * g.frame.half_height);
    });
    for (const bool everywhere : {false, true}) {
        const auto steps = [&](const std::string& hint, const std::string& words, Step to) {
            shows(hint, words, [=](const Arguments& g) { return by_steps(g, to, everywhere); });
        };
        steps("equal_angles", "the angles from the middle grow evenly, and not the places on the flat picture",
              [](double place, double half) { return std::tan(place * std::atan(half)); });
        steps("half_sizes_are_lengths", "the half sizes are taken for angles, of which you take the tangent",
              [](double place, double half) { return place * std::tan(half); });
        steps("half_sizes_are_lengths",
              "the half sizes are taken for whole angles, of whose halves you take the tangent",
              [](double place, double half) { return place * std::tan(half / 2); });
        steps("half_sizes_are_lengths", "the places on the picture are taken for angles",
              [](double place, double half) { return std::tan(place * half); });
    }
    for (const bool right_first : {false, true})
        shows("equal_angles", "the direction is turned to the side and upward by angles that grow evenly",
              [=](const Arguments& g) { return after_two_turns(g, right_first); });
    shows("aspect_twice", "the step to the right is multiplied by width / height once more", [](const Arguments& g) {
        const auto [width, height] = g.frame.image;
        return at(g, across(g.x, width) * g.frame.half_width * width / height,
                  -across(g.y, height) * g.frame.half_height);
    });
    shows("aspect_twice", "the step upward is multiplied by height / width once more", [](const Arguments& g) {
        const auto [width, height] = g.frame.image;
        return at(g, across(g.x, width) * g.frame.half_width,
                  -across(g.y, height) * g.frame.half_height * height / width);
    });
    add({"turned_round", "the direction is right but for its sign: it is taken from the picture to the eye",
         [](const WrongAnswer& w) {
             return !is_orthographic(w.question) &&
                    close(glm::normalize(direction_in(w.given)), -direction_in(w.right));
         }});
    add({"looks_backward", "the ray goes the opposite way", [](const WrongAnswer& w) {
             const auto g = arguments(w.question.input);
             return dot(direction_in(w.given), g.frame.forward) < 0;
         }});
    add({"world_axes", "the step aside is taken along the world's axes", [](const WrongAnswer& w) {
             const auto g = arguments(w.question.input);
             const double right = across(g.x, g.frame.image.width) * g.frame.half_width,
                          up = -across(g.y, g.frame.image.height) * g.frame.half_height;
             const Vec3d level = glm::normalize(cross(g.frame.forward, Vec3d{0, 1, 0}));
             const Vec3d upright = right * level + up * cross(level, g.frame.forward);
             if (is_orthographic(w.question))
                 return close(origin_in(w.given), g.frame.eye + Vec3d{right, up, 0}) ||
                        close(origin_in(w.given), g.frame.eye + upright);
             const Vec3d way = glm::normalize(direction_in(w.given));
             return close(way, glm::normalize(Vec3d{right, up, -1})) ||
                    close(way, glm::normalize(g.frame.forward + Vec3d{right, up, 0})) ||
                    close(way, glm::normalize(g.frame.forward + upright));
         }});
    return of_numbers(std::move(all));
}

}  // namespace raylab::grading::picture_rays
