#pragma once

#include "raylab/geometry/vector.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace raylab {

class Primitives;

/// The rule by which a primitive is listed in a cell of a light buffer.
enum class Listing {
    conservative,  // nothing is missing
    rectangles,    // nothing is missing: every cell of a rectangle about what is seen
    centers,       // only what the ray through a cell's centre hits, as Haines and Greenberg warn not to: something is
                   // missing
};

struct LightBufferOptions {
    int resolution = 64;  // cells along an edge of the cube: a power of two
    Listing listing = Listing::conservative;
    int threads = 1;  // that make it, the same for any number; 0: all cores
};

/// The cells of the cube about a light, each with the primitives that may stop rays to the light in it, the nearest
/// first.
struct LightLists {
    struct Entry {
        std::uint32_t primitive;  // a place in scene order
        float depth;              // nothing of it in this cell is less deep

        friend bool operator==(const Entry&, const Entry&) = default;
    };
    struct Cover {
        static constexpr std::uint32_t none = ~std::uint32_t{0};
        std::uint32_t primitive = none;
        float depth = std::numeric_limits<float>::infinity();  // what is deeper is surely in its shadow

        friend bool operator==(const Cover&, const Cover&) = default;
    };
    std::vector<std::uint32_t> first;       // of each cell's entries; one more at the end. Cells: face, row, column
    std::vector<Entry> entries;             // what lies behind a cell's cover is not listed
    std::vector<Cover> covers;              // one a cell
    std::vector<std::uint32_t> everywhere;  // in no cell: without bounds
    double tolerance = 0;  // metres: the lists hold for rays that stray by less from the straight way to the light
    double radius = 0;     // metres: no bounded primitive is farther from the light

    std::size_t bytes() const;

    /// The mean number of entries of a cell, weighted by that number: points ask mostly where things are.
    double mean_length() const;
};

LightLists light_lists(const Primitives& primitives, const Vec3d& light, const LightBufferOptions& options);

}  // namespace raylab
