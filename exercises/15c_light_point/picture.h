#pragma once

#include "dots.h"
#include "exercise.h"
#include "seen_light.h"

namespace raylab::grading::light {

// A round light over a floor, from the side: one dot for 16 of the points that the lit point gets. Below the floor a
// bar for the light that arrives at each place of it, the mean of cosine / density over all points that are seen; the
// dots are the closed form, pi (radius / distance)^2 cosine.
inline constexpr int picture_width = 480, picture_height = 260;
inline constexpr double picture_seed = 21;  // of squares
inline constexpr std::size_t places = 24;   // of the floor
inline constexpr Vec3d light_center{0.7, 0, 1.55};
inline constexpr double light_radius = 0.6;
inline constexpr double pixels_a_metre = 80, floor_row = 186;

inline Arguments on_floor(double x) { return {light_center, light_radius, {x, 0, 0}, picture_seed}; }

inline double place_of(std::size_t i) { return (static_cast<double>(i) + 0.5) / places * 6 - 3; }

/// The irradiance of a point of the floor by an answer, of a light whose radiance is 1.
inline double irradiance_by(const Arguments& given, std::span<const double> answer) {
    const SeenLight seen(given);
    double sum = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
        const auto [point, pdf] = chosen(answer, i);
        const Vec3d way = point - given.from;
        const bool is_seen = seen.side(point) >= seen.relative_radius() - 1e-4;
        const double part = is_seen ? std::max(0.0, way.z) / glm::length(way) / pdf : 0;
        sum += std::isfinite(part) ? part : 0;
    }
    return sum / static_cast<double>(pairs);
}

inline double irradiance_of_sphere(const Arguments& given) {
    const Vec3d way = given.center - given.from;
    const double squared = dot(way, way);
    return std::numbers::pi * given.radius * given.radius / squared * way.z / std::sqrt(squared);
}

inline Image draw_light(std::span<const double> answers) {
    Image image(picture_width, picture_height, paper);
    const auto at = [](double x, double z) {
        return Point2{picture_width / 2.0 + pixels_a_metre * x, floor_row - pixels_a_metre * z};
    };
    const Arguments lit = on_floor(-1.3);
    const auto dots = answers.first(outputs);
    draw_disk(image, at(light_center.x, light_center.z), pixels_a_metre * light_radius, {1, 0.93f, 0.7f});
    const Vec3d way = light_center - lit.from;
    const double middle = std::atan2(way.z, way.x), half = std::asin(light_radius / glm::length(way));
    const double tangent = std::sqrt(dot(way, way) - light_radius * light_radius);
    for (const double angle : {middle - half, middle + half})
        draw_line(image, at(lit.from.x, 0), at(lit.from.x + tangent * std::cos(angle), tangent * std::sin(angle)), 1.2,
                  ink::grey);
    const auto numbers = number_pairs(picture_seed);
    for (const std::size_t i : drawn_pairs()) {
        const Vec3d point = chosen(dots, i).point;
        draw_dot(image, at(point.x, point.z), numbers[i]);
    }
    draw_disk(image, at(lit.from.x, 0), 4, ink::black);

    constexpr double bar = 130;  // pixels for an irradiance of 1
    for (std::size_t i = 0; i < places; ++i) {
        const Arguments given = on_floor(place_of(i));
        const double light = irradiance_by(given, answers.subspan((i + 1) * outputs, outputs));
        const Point2 left = at(place_of(i) - 3.0 / places, 0), right = at(place_of(i) + 3.0 / places, 0);
        const auto shade = cast<float>(std::clamp(2 * light, 0.0, 1.0));
        fill_bar(image, {left.x, floor_row}, {right.x, floor_row + std::clamp(bar * light, -72.0, 72.0)},
                 {shade, 0.85f * shade, 0.4f * shade});
        draw_disk(image, {(left.x + right.x) / 2, floor_row + bar * irradiance_of_sphere(given)}, 2, ink::vermilion);
    }
    draw_line(image, at(-3, 0), at(3, 0), 1.5, ink::black);
    return image;
}

inline std::vector<Case> picture_cases() {
    std::vector<Case> all{{"", Case::Kind::graded, as_input(on_floor(-1.3))}};
    for (std::size_t i = 0; i < places; ++i) all.push_back({"", Case::Kind::graded, as_input(on_floor(place_of(i)))});
    return all;
}

inline Picture light_picture() {
    return {.about =
                "points of a round light for one point of the floor, coloured by u, and the light that each place of "
                "the floor gets by your points (bars), where the dots are the truth",
            .width = picture_width,
            .height = picture_height,
            .all_cases = picture_cases,
            .draw = draw_light};
}

}  // namespace raylab::grading::light
