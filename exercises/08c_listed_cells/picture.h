#pragma once

#include "arguments.h"
#include "exercise.h"

#include "raylab/accelerator/light_buffer/light_cell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace raylab::grading::listing {

// What a light sees that hangs among boards, and above a floor that runs on behind every face's light: the cube about
// it unfolded. A board is dark where it is seen through a cell that does not list it, and a veil of its colour where a
// cell lists it and it is not seen.
inline constexpr int picture_side = 64, picture_cells = 16;

struct Board {
    std::vector<Vec3d> corners;
    Vec3d color;
};

inline const std::vector<Board>& boards() {
    static const std::vector<Board> all{
        {{{-6, -1, -6}, {6, -1, -6}, {6, -1, 6}, {-6, -1, 6}}, {0.55, 0.55, 0.5}},
        {{{1.2, -0.8, -1}, {1.2, 1.5, -0.6}, {1.6, 0.2, 1.5}}, {0.85, 0.4, 0.1}},
        {{{-0.9, -0.5, -1.6}, {0.9, -0.2, -1.2}, {0.2, 1.3, -1.4}, {-0.8, 1, -1.7}}, {0.1, 0.45, 0.7}},
        {{{-1.4, 0.3, -2}, {-1.1, 1.7, -0.2}, {-1.5, 0.4, 1.9}}, {0.2, 0.6, 0.4}},
        {{{-0.4, 1, 2.5}, {0.5, 1.1, 2.5}, {0.5, 0.9, -2.5}, {-0.4, 0.8, -2.5}}, {0.75, 0.6, 0.15}},
        {{{-0.7, -0.5, 1.4}, {0.3, -0.6, 1.2}, {0.6, 0.5, 1.6}, {0, 0.8, 1.7}, {-0.6, 0.4, 1.6}}, {0.65, 0.35, 0.6}}};
    return all;
}

/// The direction that a pixel of the unfolded cube shows; -z stands in the middle of the cross.
inline std::optional<Vec3d> shown_direction(int x, int y) {
    const int column = x / picture_side, row = y / picture_side;
    const double right = 2 * ((x + 0.5) / picture_side - column) - 1, up = 1 - 2 * ((y + 0.5) / picture_side - row);
    if (row == 0 && column == 1) return Vec3d{right, 1, up};
    if (row == 2 && column == 1) return Vec3d{right, -1, -up};
    if (row != 1) return std::nullopt;
    const std::array<Vec3d, 4> around{Vec3d{-1, up, -right}, Vec3d{right, up, -1}, Vec3d{1, up, right},
                                      Vec3d{-right, up, 1}};
    return around[static_cast<std::size_t>(column)];
}

/// How far along a direction a board is; infinite where it is not.
inline double distance_of(const Board& board, const Vec3d& direction) {
    const auto& p = board.corners;
    const Vec3d normal = cross(p[1] - p[0], p[2] - p[0]);
    const double t = dot(normal, p[0]) / dot(normal, direction);
    if (!(t > 0)) return std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < p.size(); ++i)
        if (dot(cross(p[(i + 1) % p.size()] - p[i], t * direction - p[i]), normal) < 0)
            return std::numeric_limits<double>::infinity();
    return t;
}

inline std::vector<Case> room_cases() {
    std::vector<Case> all;
    for (int face = 0; face < 6; ++face)
        for (const Board& board : boards())
            all.push_back({"", Case::Kind::graded, as_input({board.corners, face, picture_cells})});
    return all;
}

inline Vec3d room_color(const Vec3d& direction, std::span<const double> answers) {
    int axis = 0;
    for (const int other : {1, 2})
        if (std::abs(direction[other]) > std::abs(direction[axis])) axis = other;
    const double size = std::abs(direction[axis]);
    const auto cell = [&](int along) {
        const double place = (direction[(axis + along) % 3] / size + 1) / 2 * picture_cells;
        return std::min(static_cast<int>(place), picture_cells - 1);
    };
    const int face = 2 * axis + (direction[axis] < 0 ? 1 : 0), column = cell(1), row = cell(2);
    const auto is_listed = [&](std::size_t board) {
        const auto cells =
            read_cells(answers.subspan((static_cast<std::size_t>(face) * boards().size() + board) * outputs));
        return cells && column >= cells->first_column && column <= cells->last_column && row >= cells->first_row &&
               row <= cells->last_row;
    };
    std::size_t nearest = 0;
    double depth = std::numeric_limits<double>::infinity();
    Vec3d color{0.78, 0.86, 0.95};
    for (std::size_t i = 0; i < boards().size(); ++i) {
        if (is_listed(i)) color = 0.82 * color + 0.18 * boards()[i].color;
        const double t = distance_of(boards()[i], direction);
        if (t < depth) depth = t, nearest = i;
    }
    if (!std::isfinite(depth)) return color;
    return is_listed(nearest) ? boards()[nearest].color : Vec3d{0.08, 0, 0};
}

inline Image draw_room(std::span<const double> answers) {
    Image image(4 * picture_side, 3 * picture_side);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const auto direction = shown_direction(x, y);
            const Vec3d color = direction ? room_color(*direction, answers) : Vec3d{1, 1, 1};
            image.at(x, y) = {cast<float>(color.x), cast<float>(color.y), cast<float>(color.z)};
        }
    return image;
}

inline Picture room_picture() {
    return {.about = "what a light sees through the cells about it; dark: seen, and not listed",
            .width = 4 * picture_side,
            .height = 3 * picture_side,
            .all_cases = room_cases,
            .draw = draw_room};
}

}  // namespace raylab::grading::listing
