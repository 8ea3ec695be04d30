#pragma once

#include "raylab/number/arithmetic_probe.h"

#include <span>

namespace raylab {

/// A part of the program that is compiled with flags of its own, and what they did.
struct CompiledPart {
    const char* name;
    CompiledFaults (*faults)();
};

/// All parts that decide geometry: the library's, every slot or what replaces it, and the program.
std::span<const CompiledPart> compiled_parts();

/// Made where a thread begins to ask for hits: asserts that nothing in this program or thread computes otherwise than
/// error bounds assume.
class ExactArithmetic {
public:
    ExactArithmetic();
};

}  // namespace raylab
