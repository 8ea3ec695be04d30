#include "raylab/number/exact_arithmetic.h"

#include <algorithm>
#include <cassert>

namespace raylab {

namespace {

// Probed once, because compiled code does not change.
[[maybe_unused]] bool is_compiled_exactly() {
    static const bool exactly = std::ranges::all_of(
        compiled_parts(), [](const CompiledPart& part) { return part.faults() == CompiledFaults{}; });
    return exactly;
}

}  // namespace

ExactArithmetic::ExactArithmetic() {
    [[maybe_unused]] const ThreadFaults faults = thread_faults();
    assert(!faults.rounds_directed && "raylab decides exactly in rounding to nearest, which this thread has left");
    assert(!faults.flushes_subnormals &&
           "raylab decides exactly with subnormal numbers, which this thread takes for zero: is it linked with "
           "-ffast-math?");
    assert(is_compiled_exactly() &&
           "raylab decides exactly where every operation is rounded, but a part of this program is compiled without "
           "cmake/flags.cmake's flags: compiled_parts() names it");
}

}  // namespace raylab
