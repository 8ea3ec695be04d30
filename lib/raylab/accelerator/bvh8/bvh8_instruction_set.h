#pragma once

#include <hwy/targets.h>

#include <cstddef>

namespace raylab {

/// Which code in the tables that Highway makes is that of the best instruction set of this machine (or of those that a
/// test has left).
inline std::size_t best_instruction_set() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return hwy::GetChosenTarget().GetIndex();
}

}  // namespace raylab
