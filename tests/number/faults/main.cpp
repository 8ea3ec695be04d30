#include "raylab/number/arithmetic_probe.h"

#include <cstdio>

// Prints the effects of this file's compiler flags as words on one line; arithmetic_probe.cpp compiles it with several
// sets of flags.
int main() {
    const auto compiled = raylab::compiled_faults();
    const auto thread = raylab::thread_faults();
    std::printf("%s%s%s%s%s", compiled.contracts ? " contracts" : "", compiled.reassociates ? " reassociates" : "",
                compiled.skips_rounding ? " skips_rounding" : "", thread.rounds_directed ? " rounds_directed" : "",
                thread.flushes_subnormals ? " flushes_subnormals" : "");
}
