#pragma once

#include "exercise.h"

#include <span>
#include <vector>

namespace raylab::grading {

/// The cases of every pixel, row by row from the top.
std::vector<Case> cases_of(const Picture& picture);

/// The picture from the exercise's answers to cases_of(its picture); pixels without answers stay black.
Image drawn(const Exercise& exercise, std::span<const double> answers);

}  // namespace raylab::grading
