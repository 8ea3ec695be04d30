#include "cases.h"

#include <utility>

namespace raylab::spread {

std::vector<StabilityCase> cases(const ChapterRun& run) {
    std::vector<StabilityCase> all = sampling_cases(run);
    for (const auto& more : {light_cases(run), stopping_cases(run)}) all.insert(all.end(), more.begin(), more.end());
    return all;
}

}  // namespace raylab::spread
