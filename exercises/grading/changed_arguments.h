#pragma once

#include "exercise.h"

#include <vector>

namespace raylab::grading {

/// Symptoms of an argument that is not used, or not as it is meant: what is given is right, by the exercise's own
/// judge, for the same case with an argument left out, turned round, squared, of length 1, or in another's place. They
/// keep a reference to the exercise. None where it does not name its arguments.
std::vector<Symptom> changed_argument_symptoms(const Exercise& exercise);

}  // namespace raylab::grading
