#include "catch.h"

#include "raylab/base/process.h"

#include <filesystem>
#include <string>
#include <vector>

// Tests of the effects of other flags: small files are compiled here as no file of the lab is.

using namespace raylab;
using Catch::Contains;

namespace {

ProcessResult compiled(std::vector<std::string> words) {
    words.insert(words.begin(), {"-std=c++20", "-I" RAYLAB_SOURCE "/lib"});
    return run_process(RAYLAB_COMPILER, words, {.timeout = 60});
}

// The faults of a program compiled with these flags.
std::string faults(std::vector<std::string> flags) {
    const auto program = std::filesystem::path(RAYLAB_BUILD) / "tests/number/faults";
    std::filesystem::create_directories(program.parent_path());
    flags.insert(flags.end(), {RAYLAB_SOURCE "/tests/number/faults/main.cpp", "-o", program.string()});
    const auto made = compiled(flags);
    INFO(made.errors);
    REQUIRE(made.succeeded());
    const auto result = run_process(program, {}, {.timeout = 60});
    REQUIRE(result.succeeded());
    return result.output;
}

#if defined(__x86_64__)
constexpr const char* with_fma = "-mfma";
bool can_fuse() { return __builtin_cpu_supports("fma"); }
#elif defined(__aarch64__)
constexpr const char* with_fma = "-march=armv8-a";  // which has it always
bool can_fuse() { return true; }
#else
constexpr const char* with_fma = "-mfma";
bool can_fuse() { return false; }  // other machines fuse without -mfma, or not at all
#endif

}  // namespace

TEST_CASE("contraction is found out") {
    if (!can_fuse()) {
        WARN("skipped: no fused multiply-add here");
        return;
    }
    CHECK(faults({"-O2", with_fma, "-ffp-contract=off", "-fno-tree-slp-vectorize"}) == "");
    CHECK(faults({"-O2", with_fma, "-ffp-contract=fast", "-fno-tree-slp-vectorize"}) == " contracts");
}

#if defined(__GNUC__) && !defined(__clang__) && __GNUC__ == 12 && defined(__x86_64__)  // on ARM it keeps the rounding
TEST_CASE("GCC 12's SLP vectoriser, which loses the rounding to float, is found out") {
    CHECK(faults({"-O2", "-ffp-contract=off"}) == " skips_rounding");
}
#endif

TEST_CASE("fast math is refused by the compiler") {
    const std::string header = RAYLAB_SOURCE "/lib/raylab/number/scalar.h";
    for (const char* flag : {"-ffast-math", "-Ofast", "-ffinite-math-only"}) {
        INFO(flag);
        const auto result = compiled({flag, "-fsyntax-only", "-x", "c++", header});
        CHECK_FALSE(result.succeeded());
        CHECK_THAT(result.errors, Contains("raylab decides exactly by IEEE 754"));
    }
    CHECK(compiled({"-O2", "-fsyntax-only", "-x", "c++", header}).succeeded());
}

#if defined(__x86_64__) || defined(__aarch64__)
TEST_CASE("sums that are reassociated and subnormal numbers that are flushed are found out") {
    // Linked with -ffast-math, a program starts with both of MXCSR's flags set, or with FPCR's one.
    CHECK_THAT(faults({"-O2", "-ffast-math"}), Contains(" reassociates") && Contains(" flushes_subnormals"));
    CHECK_THAT(faults({"-O2", "-ffp-contract=off"}), !Contains(" reassociates") && !Contains(" flushes_subnormals"));
}
#endif
