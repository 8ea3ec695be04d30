#pragma once

#include "work_task.h"

#include "raylab/image/image.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

// What an exercise is to the grader: cases in, doubles out, and a judge that trusts nothing but the doubles.

namespace raylab::grading {

/// One question put to a student's function, as the doubles of its arguments.
struct Case {
    enum class Kind {
        graded,       // keeps a margin from every decision boundary that any correct double method respects
        adversarial,  // shown ("how sturdy is yours?"), never counted
    };
    std::string group;  // "inside start"
    Kind kind = Kind::graded;
    std::vector<double> input;
};

/// What the judge says of one answer.
struct Judgement {
    enum class Outcome { right, wrong, nonfinite } outcome = Outcome::wrong;
    std::string expected, got;  // in the reader's words: "a hit at t = 1.25", "no hit"
};

/// An answer that came with the exercise: a typical mistake, or a right answer of another shape.
struct KnownAnswer {
    std::string name;
    std::string hint;  // what to say to who answers like this; several mistakes may share it
    Answer answer;
};

/// A picture drawn with the function under test: each pixel asks its cases, and their answers give its colour.
struct Picture {
    std::string about;  // what it shows
    int width = 0, height = 0;
    std::function<std::vector<Case>(int x, int y)> cases;  // as many for every pixel
    std::function<Pixel(int x, int y, std::span<const double> answers)> shade;  // of all cases of the pixel, one after the other
};

struct Exercise {
    std::string folder;    // "02_ray_sphere"
    std::string slot;      // the function and its file: "nearest_sphere_hit"
    std::string chapter;   // "02_spheres_and_quadrics"
    std::string chart;     // the chapter's question on whose chart `yours` is a dot; empty: none
    bool traced = false;   // whether the textbook's tracer has the slot in it, and can be built with another function
    std::size_t inputs = 0, outputs = 0;  // doubles a case
    std::function<std::vector<Case>(std::uint64_t seed)> cases;
    std::function<Judgement(const Case&, std::span<const double> answer)> judge;
    std::function<std::string(const Case&)> story;  // the case in words: where the ray goes, and why the truth is so
    Picture picture;
    std::vector<WorkTask> work = {};  // what the function is used for; empty: only its answers are judged
    Answer reference;
    std::vector<KnownAnswer> mistakes;
    std::vector<KnownAnswer> right;
};

/// All exercises, in order.
const std::vector<Exercise>& exercises();

/// By number ("2", "02", "7b") or folder. Error names the known ones.
const Exercise& exercise(const std::string& name);

}  // namespace raylab::grading
