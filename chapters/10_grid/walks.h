#pragma once

#include "raylab/accelerator/grid/grid_planes.h"
#include "raylab/geometry/ray.h"
#include "raylab/report/chapter.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// Which cells does a ray pass? Compares the grid's traversal, without its contents, with exact integers.

namespace raylab::grids {

/// The cube [0, 1]^3 of n x n x n cells, with its planes for the lab's GridWalk.
struct CubeOfCells {
    int n;
    GridPlanes planes;
};

/// n must be a power of two.
CubeOfCells cube_of_cells(int n);

/// The number 1 in units of a LatticeRay.
inline constexpr std::int64_t lattice_one = std::int64_t{1} << 20;

/// A ray whose numbers are integer multiples of 2^-20, so that its cells can be computed in integers.
struct LatticeRay {
    std::array<std::int64_t, 3> origin, direction;
};

/// The ray in floats; nothing is rounded.
Ray in_floats(const LatticeRay& ray);

/// A cell by its number: x + n (y + n z).
using CellNumber = std::uint64_t;
CellNumber number_of(std::int64_t x, std::int64_t y, std::int64_t z, const CubeOfCells& cube);

/// The cells that the ray passes, in order. Absent where it goes through an edge: which cells it passes is then a
/// matter of definition.
std::optional<std::vector<CellNumber>> cells_in_truth(const LatticeRay& ray, const CubeOfCells& cube);

/// How a traversal finds its next plane.
struct WalkMethod {
    std::string name, number;
    std::vector<CellNumber> (*cells)(const Ray& ray, const CubeOfCells& cube);
};
std::vector<WalkMethod> walk_methods(const ChapterRun& run);

/// The errors of a traversal over many rays.
struct WalkErrors {
    double missed = 0;      // missed cells, in ppm of those passed
    double rays = 0;        // rays that miss a cell, in percent
    std::size_t cells = 0;  // that the rays pass in truth
};
WalkErrors walk_errors(const WalkMethod& method, const CubeOfCells& cube, std::size_t rays, std::uint64_t seed);

/// A cell that a ray passes and a traversal does not, with both ways.
struct LostCell {
    Ray ray;
    std::vector<CellNumber> truth, walked;  // in order
    std::size_t lost = 0;                   // its place in `truth`, neither the first nor the last one
};
std::optional<LostCell> first_lost_cell(const WalkMethod& method, const CubeOfCells& cube, std::size_t rays,
                                        std::uint64_t seed);

/// The question "grid_walk".
Experiment measure_walks(const ChapterRun& run);

}  // namespace raylab::grids
