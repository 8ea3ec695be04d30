#pragma once

#include "case.h"
#include "symptom.h"
#include "work_task.h"

#include "raylab/image/image.h"
#include "raylab/report/plane/plane_drawing.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

// An exercise from the grader's side: cases in, doubles out, and a judge that trusts nothing except the doubles.

namespace raylab::grading {

/// An answer that comes with the exercise: a typical mistake, or a right answer in another form.
struct KnownAnswer {
    std::string name;
    std::string hint;  // the hint for an answer like this; several mistakes may share it
    Answer answer;
};

/// A picture drawn with the function under test: each pixel has cases, whose answers determine its colour.
struct Picture {
    std::string about;  // a caption
    int width = 0, height = 0;
    std::function<std::vector<Case>(int x, int y)> cases = {};  // the same number for every pixel
    // The answers to all cases of the pixel, one after the other.
    std::function<Pixel(int x, int y, std::span<const double> answers)> shade = {};
    // Of a picture whose dots and curves are not any one pixel's, these stand for the two above: the cases of the whole
    // picture, and the picture by the answers to them.
    std::function<std::vector<Case>()> all_cases = {};
    std::function<Image(std::span<const double> answers)> draw = {};
};

struct Exercise {
    std::string folder;   // "02_ray_sphere"
    std::string slot;     // the name of the function and its file: "nearest_sphere_hit"
    std::string chapter;  // "02_spheres_and_quadrics"
    std::string chart;    // the chapter's question in whose chart `yours` is a dot; empty: none
    // Whether the textbook's tracer contains the slot, so that it can be built with another function.
    bool traced = false;
    std::size_t inputs = 0, outputs = 0;  // doubles for each case
    std::vector<Part> arguments = {};     // in the order of a case's doubles; empty: no few numbers and vectors
    std::function<std::vector<Case>(std::uint64_t seed)> cases;
    std::function<Judgement(const Case&, std::span<const double> answer)> judge;
    std::vector<Part> parts = {};  // of the answer, in the order of its numbers; empty: only the judge knows
    // What wrong answers have in common, the special before the general.
    std::vector<Symptom> symptoms = {};
    // What of an answer tells one mistake from another, where that is not its numbers: two functions may spread points
    // over a lens equally badly and no point is the same. Empty: the numbers of the answer.
    std::function<std::vector<double>(const Case&, std::span<const double> answer)> fingerprint = {};
    double fingerprint_noise = 1e-9;  // by which those of one mistake differ, relative to 1 or the larger one
    // The case in words: where the ray goes, and why the truth is what it is.
    std::function<std::string(const Case&)> story;
    // The case as a drawing with an answer in it; empty: there is none.
    std::function<PlaneDrawing(const Case&, std::span<const double> answer)> sketch = {};
    Picture picture;
    std::vector<WorkTask> work = {};  // what the function is used for; empty: only its answers are judged
    Answer reference;
    std::vector<KnownAnswer> mistakes;
    std::vector<KnownAnswer> right;
};

/// All exercises, in order.
const std::vector<Exercise>& exercises();

/// An exercise by its number ("2", "02", "7b") or folder. An Error lists the known ones.
const Exercise& exercise(const std::string& name);

}  // namespace raylab::grading
