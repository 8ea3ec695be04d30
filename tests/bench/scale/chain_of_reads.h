#pragma once

#include "bench/seconds_of.h"
#include "raylab/base/large_pages.h"
#include "raylab/experiment/measure/quantile.h"

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace raylab::bench {

/// Nanoseconds of a read at a random place of so much memory, on large pages, where each read is told its place by the
/// one before: a step of a walk cannot take less where its node lies in none of the near caches.
inline double nanoseconds_of_a_read(double bytes) {
    struct alignas(64) Line {
        std::uint32_t next;
    };
    LargeVector<Line> lines(1 + static_cast<std::size_t>(bytes) / sizeof(Line));
    for (std::uint32_t i = 0; i < lines.size(); ++i) lines[i].next = i;
    std::mt19937_64 random(1);
    // One cycle through all (S. Sattolo, An Algorithm to Generate a Random Cyclic Permutation, 1986).
    for (std::size_t i = lines.size(); --i > 0;)
        std::swap(lines[i].next, lines[std::uniform_int_distribution<std::size_t>(0, i - 1)(random)].next);
    constexpr int count = 1 << 20, repetitions = 5;
    std::uint32_t at = 0;
    std::vector<double> times;
    for (int repetition = 0; repetition < repetitions; ++repetition)
        times.push_back(seconds_of(CLOCK_PROCESS_CPUTIME_ID, [&] {
            for (int i = 0; i < count; ++i) at = lines[at].next;
        }));
    return at < lines.size() ? 1e9 * median(times) / count : 0;  // (Read, so that no read is left out.)
}

}  // namespace raylab::bench
