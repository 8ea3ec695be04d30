#include "catch.h"

#include "raylab/number/exact_arithmetic.h"

#include <cfenv>
#include <cstdint>
#include <set>
#include <string>

using namespace raylab;

TEST_CASE("every part of the program is compiled as exactness needs") {
    std::set<std::string> names;
    for (const auto& [name, faults] : compiled_parts()) {
        INFO(name);
        CHECK(faults() == CompiledFaults{});
        names.insert(name);
    }
    for (const char* name : {"library", "rays", "text", "program", "triangle_hit", "sah_cost"}) {
        INFO(name);
        CHECK(names.contains(name));
    }
}

TEST_CASE("a thread that does not round to nearest is found out") {
    CHECK(thread_faults() == ThreadFaults{});
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const ThreadFaults faults = thread_faults();
        std::fesetround(FE_TONEAREST);
        CHECK(faults.rounds_directed);
    }
}

// (By builtins: a batch of tests includes every header, and xmmintrin.h is not everywhere.)
#if defined(__SSE__)
TEST_CASE("a thread that takes subnormal numbers for zero is found out, as operands and as results") {
    constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x40;
    const unsigned usual = __builtin_ia32_stmxcsr();
    for (const unsigned flag : {flush_to_zero, denormals_are_zero}) {
        __builtin_ia32_ldmxcsr(usual | flag);
        const ThreadFaults faults = thread_faults();
        __builtin_ia32_ldmxcsr(usual);
        CHECK(faults == ThreadFaults{.flushes_subnormals = true});
    }
}
#elif defined(__aarch64__)
TEST_CASE("a thread that takes subnormal numbers for zero is found out") {
    constexpr std::uint64_t flush_to_zero = 1 << 24;
    std::uint64_t usual;
    asm volatile("mrs %0, fpcr" : "=r"(usual));
    asm volatile("msr fpcr, %0" : : "r"(usual | flush_to_zero));
    const ThreadFaults faults = thread_faults();
    asm volatile("msr fpcr, %0" : : "r"(usual));
    CHECK(faults == ThreadFaults{.flushes_subnormals = true});
}
#endif
