#include "exercise.h"

#include "exercise_list.h"

#include "raylab/base/error.h"

#include <algorithm>

namespace raylab::grading {

namespace {

// "07b" -> "7b".
std::string without_zeros(const std::string& number) {
    return number.substr(std::min(number.find_first_not_of('0'), number.size()));
}

// "2", "02" and "02_ray_sphere" all mean the second exercise; "7b" and "07b" the second of chapter 7.
bool names(const std::string& name, const Exercise& exercise) {
    if (name == exercise.folder) return true;
    const auto number = without_zeros(exercise.folder.substr(0, exercise.folder.find('_')));
    return without_zeros(name) == number;
}

}  // namespace

const std::vector<Exercise>& exercises() {
    static const std::vector<Exercise> all = listed_exercises();
    return all;
}

const Exercise& exercise(const std::string& name) {
    std::string known;
    for (const auto& exercise : exercises()) {
        if (names(name, exercise)) return exercise;
        known += (known.empty() ? "" : ", ") + exercise.folder;
    }
    throw Error("expected an exercise (" + known + "), found '" + name + "'");
}

}  // namespace raylab::grading
