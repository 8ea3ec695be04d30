#pragma once

#include "raylab/report/chapter_run.h"

#include <string>
#include <vector>

namespace raylab::spread {

/// How fast each sampler's error falls: measured slopes, beside an edge and where the integrand is smooth.
std::vector<std::string> slope_header();
std::vector<std::vector<std::string>> slope_rows(const ChapterRun& run);

/// Chapter 14's box by paths, and by radiosity with ever more patches: the mean of the picture.
std::vector<std::string> box_header();
std::vector<std::vector<std::string>> box_rows(const ChapterRun& run);

}  // namespace raylab::spread
