#pragma once

#include "raylab/number/arithmetic_probe.h"

#include <span>

namespace raylab {

/// A part of the program that is compiled with its own flags, and the probe of their effect.
struct CompiledPart {
    const char* name;
    CompiledFaults (*faults)();
};

/// All parts that make geometric decisions: the library's, every slot or its replacement, and the program's.
std::span<const CompiledPart> compiled_parts();

/// Constructed where a thread begins to query hits: asserts that nothing in this program or thread computes differently
/// from what error bounds assume.
class ExactArithmetic {
public:
    ExactArithmetic();
};

}  // namespace raylab
