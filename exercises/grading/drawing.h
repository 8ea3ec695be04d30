#pragma once

#include "exercise.h"

#include <span>
#include <vector>

namespace raylab::grading {

/// The cases of every pixel, row by row from the top, or those of the whole picture.
std::vector<Case> cases_of(const Picture& picture);

/// The picture from the exercise's answers to cases_of(its picture); pixels without answers stay black, and
/// so does a picture that is drawn as a whole if one is missing.
Image drawn(const Exercise& exercise, std::span<const double> answers);

}  // namespace raylab::grading
