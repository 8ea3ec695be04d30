#include "raylab/experiment/measure/measure.h"

#include "raylab/experiment/measure/quantile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <ctime>

namespace raylab {

namespace {

using Clock = MeasureOptions::Clock;

double seconds_now(Clock clock) {
    timespec now;
    clock_gettime(clock == Clock::wall ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_for(std::size_t passes, const std::function<void()>& run, Clock clock) {
    const double start = seconds_now(clock);
    for (std::size_t pass = 0; pass < passes; ++pass) {
        run();
        // Makes the compiler assume that all memory is read after each pass; otherwise it might remove passes.
        asm volatile("" ::: "memory");
    }
    return seconds_now(clock) - start;
}

// The number of passes that last at least `shortest` seconds. The passes that determine it are the warm-up.
std::size_t passes_lasting(double shortest, const std::function<void()>& run, Clock clock) {
    std::size_t passes = 1;
    while (true) {
        const double seconds = seconds_for(passes, run, clock);
        if (seconds >= shortest || passes >= std::size_t{1} << 30) return passes;
        const double wanted = 1.2 * shortest / std::max(seconds, 1e-9);  // the factor 1.2 makes the next round the last
        passes = static_cast<std::size_t>(std::ceil(static_cast<double>(passes) * std::clamp(wanted, 2.0, 100.0)));
    }
}

}  // namespace

Spread spread_of(std::vector<double> values) {
    assert(!values.empty());
    std::ranges::sort(values);
    return {quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75)};
}

Spread time_per_query(std::size_t queries, const std::function<void()>& run, const MeasureOptions& options) {
    assert(options.repeats > 0);
    if (queries == 0) return {};
    const std::size_t passes = passes_lasting(options.shortest, run, options.clock);
    const double answers = static_cast<double>(passes) * static_cast<double>(queries);
    std::vector<double> nanoseconds;
    for (int repeat = 0; repeat < options.repeats; ++repeat)
        nanoseconds.push_back(1e9 * seconds_for(passes, run, options.clock) / answers);
    return spread_of(nanoseconds);
}

}  // namespace raylab
