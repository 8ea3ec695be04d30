#include "exercise.h"

#include "exercise_list.h"

#include "raylab/base/error.h"

#include <charconv>

namespace raylab::grading {

namespace {

// "2", "02" and "02_ray_sphere" all mean the second exercise.
bool names(const std::string& name, const Exercise& exercise) {
    if (name == exercise.folder) return true;
    int number = 0;
    const auto [end, problem] = std::from_chars(name.data(), name.data() + name.size(), number);
    return problem == std::errc{} && end == name.data() + name.size() && number == std::stoi(exercise.folder);
}

}  // namespace

const std::vector<Exercise>& exercises() {
    static const std::vector<Exercise> all{picture_ray_exercise(), ray_sphere_exercise(), ray_triangle_exercise(),
                                           transformed_normal_exercise(), phong_specular_exercise(),
                                           refraction_exercise()};
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
