#pragma once

#include "drawings.h"

#include "raylab/report/chapter.h"

#include <cstdint>
#include <string>
#include <vector>

namespace raylab::ray_generation {

/// The same small picture computed backward and forward, and where the forward rays ended.
struct Directions {
    // Backward; forward with as many rays, and with many more. The forward pictures are darkened, so that a dot shows
    // its colour.
    Image backward, forward, forward_more;
    std::vector<std::vector<std::string>> fates;  // a row for each radius of the eye, and one for a pupil
};

std::vector<std::string> light_ray_header();

Directions compare_directions(const ChapterRun& run, const Stage& stage);

}  // namespace raylab::ray_generation
