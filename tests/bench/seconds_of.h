#pragma once

#include <ctime>
#include <functional>

namespace raylab::bench {

/// How long it took by a clock: CLOCK_MONOTONIC, or CLOCK_PROCESS_CPUTIME_ID for what this process did alone.
inline double seconds_of(clockid_t clock, const std::function<void()>& work) {
    const auto now = [&] {
        timespec at{};
        clock_gettime(clock, &at);
        return static_cast<double>(at.tv_sec) + 1e-9 * static_cast<double>(at.tv_nsec);
    };
    const double begun = now();
    work();
    return now() - begun;
}

}  // namespace raylab::bench
