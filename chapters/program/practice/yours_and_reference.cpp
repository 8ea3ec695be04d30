#include "yours_and_reference.h"

#include "asking.h"
#include "drawing.h"
#include "judging.h"

#include "raylab/image/compare.h"
#include "raylab/image/difference_picture.h"
#include "raylab/image/draw.h"

#include <fmt/format.h>

namespace raylab {

using namespace grading;

namespace {

// Of a picture that is drawn as a whole no difference is shown: another right function has other dots.
Image beside_each_other(const Picture& picture, const Image& yours, const Image& truth) {
    if (picture.draw) return side_by_side({with_caption(yours, "yours"), with_caption(truth, "reference")});
    const Image large = enlarged(yours, 2), large_truth = enlarged(truth, 2);
    return difference_picture(large, large_truth, compare(large, large_truth));
}

// The last answers of a process that was killed may not have arrived: it fails there, or a few pixels later.
std::string place_in(const Exercise& exercise, std::size_t answered) {
    const auto& picture = exercise.picture;
    if (picture.draw) return "";
    const auto pixel = static_cast<int>(answered / picture.cases(0, 0).size());
    return fmt::format("from pixel ({}, {}) on ", pixel % picture.width, pixel / picture.width);
}

std::string missing_in(const Exercise& exercise, const Answers& answers) {
    if (answers.end == Answers::End::complete) return {};
    return "  No whole picture: " + place_in(exercise, answers.values.size() / exercise.outputs) +
           to_text(exercise, answers);
}

}  // namespace

BesideEachOther yours_and_reference(const Exercise& exercise, const Workplace& workplace) {
    const auto cases = cases_of(exercise.picture);
    const auto answers = run(exercise, workplace, inputs_of(cases));
    const auto truth = drawn(exercise, answers_of(exercise, exercise.reference, cases));
    return {beside_each_other(exercise.picture, drawn(exercise, answers.values), truth), missing_in(exercise, answers)};
}

}  // namespace raylab
