#pragma once

#include "judging.h"
#include "rotating.h"
#include "sanitized.h"

#include <cstdint>
#include <vector>

/// Of the seeds 1 to `most`, a multiple of 10, the tenth with which this run judges. Under a sanitizer, which is slow,
/// it is one seed.
inline std::vector<std::uint64_t> seeds_of_this_run(std::uint64_t most) {
    std::vector<std::uint64_t> seeds;
    for (std::uint64_t seed = 1; seed <= (is_sanitized ? 10 : most); ++seed)
        if (is_tested_now(seed, 10)) seeds.push_back(seed);
    return seeds;
}

/// All exercises; under a sanitizer, those whose code is instrumented: a part (RAYLAB_PART, exercises/CMakeLists.txt).
inline std::vector<raylab::grading::Exercise> exercises_of_this_run() {
    const auto& all = raylab::grading::exercises();
    std::vector<raylab::grading::Exercise> asked;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!is_sanitized || i % RAYLAB_PARTS == RAYLAB_PART_FIRST) asked.push_back(all[i]);
    return asked;
}
