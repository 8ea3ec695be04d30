#include "walks.h"

#include "raylab/accelerator/grid/grid_walk.h"
#include "raylab/sampling/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab::grids {

namespace {

template <Real T>
struct Set {
    std::array<T, 3> next, step;
    std::array<std::int64_t, 3> cell;
};

std::int64_t towards(double direction) { return direction > 0 ? 1 : -1; }

template <Real T>
T plane_t(const Ray& ray, int axis, std::int64_t cell, int n) {
    const bool forward = ray.direction[axis] > 0;
    const T plane = static_cast<T>(cell + (forward ? 1 : 0)) / static_cast<T>(n);
    return (plane - cast<T>(ray.origin[axis])) / cast<T>(ray.direction[axis]);
}

// The first cell, from the point of entry, as in textbooks.
template <Real T>
std::optional<Set<T>> entered(const Ray& ray, int n) {
    T enter = 0, leave = std::numeric_limits<T>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const T inverse = 1 / cast<T>(ray.direction[axis]), origin = cast<T>(ray.origin[axis]);
        const T a = (0 - origin) * inverse, b = (1 - origin) * inverse;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    if (!(enter <= leave)) return std::nullopt;
    Set<T> set{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const T place = (cast<T>(ray.origin[axis]) + enter * cast<T>(ray.direction[axis])) * static_cast<T>(n);
        set.cell[i] = std::clamp(static_cast<std::int64_t>(place), std::int64_t{0}, std::int64_t{n} - 1);
        set.next[i] = plane_t<T>(ray, axis, set.cell[i], n);
        set.step[i] = std::abs(1 / (static_cast<T>(n) * cast<T>(ray.direction[axis])));
    }
    return set;
}

enum class Planes { added, recomputed };

// The loop of Amanatides and Woo: the nearest of three planes ahead is next; its t is incremented, or computed anew.
template <Real T, Planes planes>
std::vector<CellNumber> textbook(const Ray& ray, const CubeOfCells& cube) {
    std::vector<CellNumber> cells;
    auto set = entered<T>(ray, cube.n);
    while (set) {
        cells.push_back(number_of(set->cell[0], set->cell[1], set->cell[2], cube));
        const auto i = static_cast<std::size_t>(std::ranges::min_element(set->next) - set->next.begin());
        const int axis = static_cast<int>(i);
        set->cell[i] += towards(ray.direction[axis]);
        if (set->cell[i] < 0 || set->cell[i] >= cube.n) break;
        set->next[i] =
            planes == Planes::added ? set->next[i] + set->step[i] : plane_t<T>(ray, axis, set->cell[i], cube.n);
    }
    return cells;
}

// Exercise 10's function, called repeatedly.
std::vector<CellNumber> by_next_cell(const Ray& ray, const CubeOfCells& cube) {
    std::vector<CellNumber> cells;
    const auto start = entered<double>(ray, cube.n);
    if (!start) return cells;
    const UniformGrid grid{{0, 0, 0}, 1.0 / cube.n, {cube.n, cube.n, cube.n}};
    std::optional<Cell> cell =
        Cell{static_cast<int>(start->cell[0]), static_cast<int>(start->cell[1]), static_cast<int>(start->cell[2])};
    const auto largest = static_cast<std::size_t>(3 * cube.n);  // for a student's function that never ends
    while (cell && cells.size() < largest) {
        cells.push_back(number_of((*cell)[0], (*cell)[1], (*cell)[2], cube));
        cell = next_cell(in<double>(ray), grid, *cell);
    }
    return cells;
}

std::vector<CellNumber> raylabs(const Ray& ray, const CubeOfCells& cube) {
    std::vector<CellNumber> cells;
    GridWalk walk(cube.planes, ray);
    for (bool inside = walk.enters(); inside; inside = walk.next()) cells.push_back(walk.index());
    return cells;
}

// A ray from outside the cube towards a point in it, never along an axis.
LatticeRay drawn(std::uint64_t seed, std::uint64_t number) {
    std::uint64_t dimension = 0;
    const auto whole = [&](double low, double high) {
        const double x = random_number({.seed = seed, .pixel = number, .dimension = dimension++});
        return static_cast<std::int64_t>(std::llround((low + (high - low) * x) * static_cast<double>(lattice_one)));
    };
    LatticeRay ray{};
    const std::size_t before = number % 3;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = axis == before ? whole(-1.5, -0.1) : whole(-0.5, 1.5);
        ray.direction[axis] = whole(0, 1) - ray.origin[axis];
        if (ray.direction[axis] == 0) ray.direction[axis] = 1;
    }
    return ray;
}

struct Asked {
    std::vector<Ray> rays;
    std::vector<std::vector<CellNumber>> truth;
    std::size_t cells = 0;
};

Asked asked(const CubeOfCells& cube, std::size_t rays, std::uint64_t seed) {
    Asked all;
    for (std::uint64_t number = 0; all.rays.size() < rays; ++number) {
        const LatticeRay ray = drawn(seed, number);
        auto truth = cells_in_truth(ray, cube);
        if (!truth || truth->empty()) continue;
        all.cells += truth->size();
        std::ranges::sort(*truth);
        all.truth.push_back(std::move(*truth));
        all.rays.push_back(in_floats(ray));
    }
    return all;
}

WalkErrors compared(std::span<const std::vector<CellNumber>> answers, const Asked& asked) {
    std::size_t missed = 0, rays = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        std::vector<CellNumber> walked = answers[i], lost;
        std::ranges::sort(walked);
        std::ranges::set_difference(asked.truth[i], walked, std::back_inserter(lost));
        missed += lost.size();
        rays += lost.empty() ? 0 : 1;
    }
    return {1e6 * static_cast<double>(missed) / static_cast<double>(asked.cells),
            100 * static_cast<double>(rays) / static_cast<double>(answers.size()), asked.cells};
}

}  // namespace

std::vector<WalkMethod> walk_methods(const ChapterRun& run) {
    return {{"t added", "float", textbook<float, Planes::added>},
            {"t added", "double", textbook<double, Planes::added>},
            {"t computed anew", "float", textbook<float, Planes::recomputed>},
            {run.name_of("next_cell", "next_cell()"), "double", by_next_cell},
            {"the lab's walk", "double", raylabs}};
}

WalkErrors walk_errors(const WalkMethod& method, const CubeOfCells& cube, std::size_t rays, std::uint64_t seed) {
    const Asked all = asked(cube, rays, seed);
    std::vector<std::vector<CellNumber>> answers;
    for (const Ray& ray : all.rays) answers.push_back(method.cells(ray, cube));
    return compared(answers, all);
}

std::optional<LostCell> first_lost_cell(const WalkMethod& method, const CubeOfCells& cube, std::size_t rays,
                                        std::uint64_t seed) {
    for (std::uint64_t number = 0; number < rays; ++number) {
        const LatticeRay drawn_ray = drawn(seed, number);
        const auto truth = cells_in_truth(drawn_ray, cube);
        if (!truth) continue;
        LostCell found{in_floats(drawn_ray), *truth, method.cells(in_floats(drawn_ray), cube)};
        auto walked = found.walked;
        std::ranges::sort(walked);
        for (found.lost = 1; found.lost + 1 < truth->size(); ++found.lost)
            if (!std::ranges::binary_search(walked, (*truth)[found.lost])) return found;
    }
    return std::nullopt;
}

Experiment measure_walks(const ChapterRun& run) {
    Experiment experiment{.question = "grid_walk",
                          .title = "Which cells does a ray pass?",
                          .error_axis = "cells missed [ppm]",
                          .rows = {}};
    for (const int n : {64, 512, 4096}) {
        const CubeOfCells cube = cube_of_cells(n);
        const Asked all = asked(cube, run.sized<std::size_t>(2'000, 200), run.seed);
        using Walk = Method<CubeOfCells, Ray, std::vector<CellNumber>>;
        const Workload<CubeOfCells, Ray> workload{
            fmt::format("{} cells a side", n), "rays through a cube", {cube}, all.rays};
        for (const WalkMethod& named : walk_methods(run)) {
            const Walk method{
                named.name, named.number, "", {}, [&](const auto&, auto data, auto queries, auto answers) {
                    for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = named.cells(queries[i], data.front());
                }};
            const auto judge = [&](std::span<const std::vector<CellNumber>> answers) {
                const WalkErrors errors = compared(answers, all);
                return Judgement{.error = errors.missed,
                                 .error_bound = 3e6 / static_cast<double>(errors.cells),
                                 .counts = {{"rays with a missed cell, %", errors.rays}}};
            };
            experiment.rows.push_back(measure(method, workload, judge, {.repeats = run.sized(5, 1), .shortest = 0}));
        }
    }
    return experiment;
}

}  // namespace raylab::grids
