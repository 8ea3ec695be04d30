#include "processors.h"

#include <cstddef>

namespace raylab::bench {

std::vector<int> usable_processors() {
    cpu_set_t usable;
    if (sched_getaffinity(0, sizeof usable, &usable) != 0) return {};
    std::vector<int> numbers;
    for (int i = 0; i < CPU_SETSIZE; ++i)
        if (CPU_ISSET(static_cast<std::size_t>(i), &usable)) numbers.push_back(i);
    return numbers;
}

OnProcessor::OnProcessor(std::optional<int> processor) {
    if (!processor || sched_getaffinity(0, sizeof before_, &before_) != 0) return;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<std::size_t>(*processor), &one);
    is_bound_ = sched_setaffinity(0, sizeof one, &one) == 0;
}

OnProcessor::~OnProcessor() {
    if (is_bound_) sched_setaffinity(0, sizeof before_, &before_);
}

}  // namespace raylab::bench
