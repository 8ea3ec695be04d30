#pragma once

#include "raylab/accelerator/shape_rows/shape_rows.h"
#include "raylab/geometry/ray.h"
#include "raylab/number/arithmetic_probe.h"

#include <array>
#include <cstdint>

namespace raylab {

/// Tests of one ray with many shapes at once, in doubles, compiled for one instruction set. The answers have a bit for
/// each place; a shape whose bit is not set is surely not hit.
struct RowQuestions {
    using Entries = std::array<double, ShapeRows::largest + 8>;  // room for a whole vector that begins anywhere
    struct Stops {
        std::uint32_t open, sure;  // the latter are surely hit inside ray.range
    };

    /// Which shapes may be hit up to t = end, and for these a t that none of their hits comes before (of spheres 0).
    std::uint32_t (*open)(const ShapeRows& rows, const Ray& ray, double end, Entries& entries);

    /// Which shapes may stop the ray, and which surely do.
    Stops (*stops)(const ShapeRows& rows, const Ray& ray);

    CompiledFaults (*faults)();  // of this instruction set's code
};

/// For the best instruction set of this machine.
RowQuestions best_row_questions();

}  // namespace raylab
