#pragma once

#include <array>
#include <limits>

// Probes, at run time, for what compiler flags and processor modes do to arithmetic. They are inlined into the calling
// function, and so compiled with the flags of its file and for its instruction set.

namespace raylab {

/// Changes of the compiler to arithmetic for which error bounds do not allow.
struct CompiledFaults {
    bool contracts = false;  // a * b - c is rounded once: -ffp-contract=fast or on, where there is an FMA instruction
    bool reassociates = false;    // (a + b) - a is replaced by b: -fassociative-math
    bool skips_rounding = false;  // a double rounded to float is stored unrounded: the SLP vectoriser of GCC 12

    friend bool operator==(const CompiledFaults&, const CompiledFaults&) = default;
};

/// Changes by a thread's floating-point environment (MXCSR, FPCR) for which error bounds do not allow.
struct ThreadFaults {
    bool rounds_directed = false;     // up, down or toward zero
    bool flushes_subnormals = false;  // as operands or as results

    friend bool operator==(const ThreadFaults&, const ThreadFaults&) = default;
};

/// A value that the compiler cannot know in advance.
template <class Value>
[[gnu::always_inline]] inline Value unforeseen(Value value) {
    asm volatile("" : "+m"(value));
    return value;
}

/// The faults of the calling code, when it runs on a thread without faults.
[[gnu::always_inline]] inline CompiledFaults compiled_faults() {
    const double one = unforeseen(1.0), small = unforeseen(0x1p-30), factor = one + small;
    const std::array doubles = unforeseen(std::array{factor, one + 2 * small});
    std::array<double, 2> floats;
    floats[0] = static_cast<float>(doubles[0]);
    floats[1] = static_cast<float>(doubles[1]);
    floats = unforeseen(floats);
    return {.contracts = factor * factor - (one + 2 * small) != 0,  // the square's last term, 2^-60, is rounded away
            .reassociates = (one + small * small) - one != 0,
            .skips_rounding = floats != std::array{1.0, 1.0}};
}

/// The faults of the calling thread.
[[gnu::always_inline]] inline ThreadFaults thread_faults() {
    const double one = unforeseen(1.0), small = unforeseen(0x1p-60);
    const double subnormal = unforeseen(std::numeric_limits<double>::denorm_min());
    return {.rounds_directed = one + small != one || one - small != one,
            .flushes_subnormals = !(subnormal + subnormal > 0)};
}

}  // namespace raylab
