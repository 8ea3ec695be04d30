#pragma once

#include "drawings.h"

#include "raylab/report/chapter.h"

#include <cstdint>
#include <string>
#include <vector>

namespace raylab::ray_generation {

/// The same small picture computed backward and forward, and where the forward rays ended.
struct Directions {
    std::uint64_t eye_rays;                 // of the backward picture; the first forward picture has as many light rays
    std::uint64_t times;                    // the second forward picture has this many times more
    Image backward, forward, forward_more;  // the forward pictures are darkened, so that a dot shows its colour
    std::vector<std::string> header;        // of the table below
    std::vector<std::vector<std::string>> fates;  // a row for each radius of the eye
    std::string pupil;                            // one sentence: the share for a human eye
};

Directions compare_directions(const ChapterRun& run, const Stage& stage);

}  // namespace raylab::ray_generation
