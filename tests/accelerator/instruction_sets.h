#pragma once

#include "catch.h"

#include <hwy/targets.h>

#include <cstdint>

/// Calls f() once for each instruction set that this machine has; what is built meanwhile uses that one alone.
template <class F>
void with_each_instruction_set(const F& f) {
    struct Restricted {
        explicit Restricted(std::int64_t target) { restrict_to(target); }
        ~Restricted() { restrict_to(0); }
        static void restrict_to(std::int64_t targets) {
            hwy::SetSupportedTargetsForTest(targets);
            hwy::GetChosenTarget().DeInit();  // the next structure asks anew
        }
    };
    for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
        INFO(hwy::TargetName(targets & -targets));
        const Restricted restricted(targets & -targets);
        f();
    }
}
