#pragma once

#include "arguments.h"
#include "marbles.h"

#include "raylab/accelerator/primitives.h"

#include <algorithm>
#include <array>
#include <cmath>

// The counted work: rays go through a grid of marbles, from cell to cell by next_cell(), until it returns none.

namespace raylab::grading::grid_step {

/// A cube of cells of side 1; each cell lists the marbles whose boxes reach into it.
class MarbleGrid {
public:
    static constexpr int cells_a_side = 16;

    MarbleGrid() {
        for (std::uint32_t i = 0; i < primitives_.size(); ++i) {
            const Box box = *primitives_.bounds(i);
            const Cell first = cell_of(convert<double>(box.min)), last = cell_of(convert<double>(box.max));
            for (int z = first[2]; z <= last[2]; ++z)
                for (int y = first[1]; y <= last[1]; ++y)
                    for (int x = first[0]; x <= last[0]; ++x) marbles_in_[number({x, y, z})].push_back(i);
        }
    }
    MarbleGrid(const MarbleGrid&) = delete;  // primitives_ points to scene_

    /// The first hit of a ray that begins in the grid. For each cell the function is called with the nearest hit so far
    /// as the end of the range, so that there is no next cell if the hit lies in this one.
    std::optional<Primitive> trace(const Ray& ray, const Answer& next_cell) const {
        Traversal traversal;
        Nearest nearest(ray);
        Arguments at{in<double>(ray), grid_, cell_of(convert<double>(ray.origin))};
        for (std::optional<Cell> cell = at.cell; cell;) {
            at.cell = *cell;
            for (const std::uint32_t i : marbles_in_[number(at.cell)]) primitives_.test(i, ray, nearest, traversal);
            at.ray.range.max = std::min(at.ray.range.max, nearest.limit());
            std::array<double, outputs> said{};
            next_cell(as_input(at), said);
            cell = believed(said);
        }
        const auto hit = nearest.hit();
        return hit ? std::optional(hit->primitive) : std::nullopt;
    }

private:
    static Cell cell_of(const Vec3d& point) {
        Cell cell{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            cell[axis] = std::clamp(static_cast<int>(std::floor(point[static_cast<int>(axis)])), 0, cells_a_side - 1);
        return cell;
    }
    static std::size_t number(const Cell& cell) {
        return static_cast<std::size_t>(cell[0] + cells_a_side * (cell[1] + cells_a_side * cell[2]));
    }
    // A student's process may answer anything, so an answer that is no cell of the grid ends the traversal.
    static std::optional<Cell> believed(std::span<const double> said) {
        const auto is_place = [](double x) { return x >= 0 && x < cells_a_side && x == std::floor(x); };
        if (said[0] == 0 || !std::ranges::all_of(said.subspan(1), is_place)) return std::nullopt;
        return Cell{static_cast<int>(said[1]), static_cast<int>(said[2]), static_cast<int>(said[3])};
    }

    Scene scene_ = marbles(300, cells_a_side);
    Primitives primitives_{scene_};
    UniformGrid grid_{{0, 0, 0}, 1, {cells_a_side, cells_a_side, cells_a_side}};
    std::array<std::vector<std::uint32_t>, cells_a_side * cells_a_side * cells_a_side> marbles_in_;
};

inline std::vector<WorkTask> work_tasks() {
    Dice dice(10);
    std::vector<Ray> anywhere, corner, floor;
    for (int i = 0; i < 200; ++i) {
        const Vec3d somewhere = dice.point(0.1, 15.9), above{dice.in(0.1, 15.9), dice.in(0.1, 15.9), 8};
        anywhere.push_back({convert<float>(somewhere), convert<float>(dice.direction())});
        corner.push_back({Vec3f(0.3f, 0.4f, 0.35f), convert<float>(somewhere)});
        floor.push_back({convert<float>(above), convert<float>(dice.direction())});
    }
    const auto across = [](const std::string& name, const std::vector<Ray>& rays) {
        return through_marbles<MarbleGrid>(name, "cells a ray", rays);
    };
    return {across("rays from a corner", corner), across("rays from anywhere", anywhere),
            across("rays that begin on a cell's face", floor)};
}

}  // namespace raylab::grading::grid_step
