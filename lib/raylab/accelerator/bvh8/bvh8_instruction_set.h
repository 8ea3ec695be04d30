#pragma once

#include <hwy/targets.h>

#include <cstddef>

namespace raylab {

/// Which code in the tables that Highway makes is that of the best instruction set of this machine (or of those that a
/// test has left).
inline std::size_t best_instruction_set() {
    // Where Highway compiles for one instruction set alone (NEON, on ARM), the tables have one entry.
    if ((HWY_TARGETS & (HWY_TARGETS - 1)) == 0) return 0;
    // (Asked once: in a virtual machine the host answers, each time after some 60 microseconds.)
    hwy::ChosenTarget& chosen = hwy::GetChosenTarget();
    if (!chosen.IsInitialized()) chosen.Update(hwy::SupportedTargets());
    return chosen.GetIndex();
}

}  // namespace raylab
