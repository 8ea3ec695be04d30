#include "course/grade.h"
#include "commands.h"
#include "course/idle_options.h"

#include "formats.h"
#include "official_grade.h"
#include "seeds.h"
#include "submission.h"

#include "raylab/base/command_line.h"
#include "raylab/base/common_options.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/outputs.h"
#include "raylab/base/print.h"

#include <filesystem>
#include <optional>

namespace raylab {

namespace fs = std::filesystem;
using namespace grading;

namespace {

const CommandLine grade_command_line{
    .program = "raylab grade",
    .about =
        "Grades a submission officially: what is asked cannot be foretold, and nothing runs that is not kept apart "
        "(level 2).\nExit code 0: it passes, 1: it does not, 2: it could not be graded, which the result says, "
        "too.\nA class: raylab grade 02 --class FOLDER -o REPORT, where FOLDER has a file or a folder for each "
        "student and\nmay have a course.toml. A run that was stopped goes on where it was.",
    .positionals = {{"NN", "the exercise, by number or folder; with --merge: reports", Positional::Count::any}},
    .options = {
        {"--submission", "FILE|DIR", "the file, or a folder with it"},
        {"--seed", "S", "the seed of the cases, to repeat a grading (default: a new one, or one by the key)"},
        {"--key", "FILE", "the course's key: the seed then follows from it and the names of exercise and student"},
        {"--student", "NAME", "whose submission it is"},
        {"--points", "P", "what an answer that passes is worth", "100"},
        {"--isolation", "LEVEL", "2 or 3: how far it is kept apart (default: the best that this machine has)"},
        {"--format", "NAME", "text, json, gradescope, github, junit, autolab, prairielearn or tap (default: text)"},
        {"-o,--output", "FILE", "the result, - is standard output; of a class the folder of its report", "-"},
        {"--class", "FOLDER", "grade all of a class"},
        {"--prepared", "FOLDER", "compiled headers that the gradings of a class share"},
        {"--part", "I/N", "of a class every N-th submission, from the I-th; then --merge"},
        {"--merge", "", "make one report of reports of parts: raylab grade --merge PART... -o REPORT"},
        {"--regrade", "", "of a class also what was asked cases that have changed since, by the same seed"},
        {"--pseudonyms", "", "of a class: names that only who has the key can tell"},
        {"--jobs", "N", "of a class: submissions at a time (default: all cores)"},
        {"--scene", "SCENE", "grade a picture instead: of this scene"},
        {"--reference", "R.exr", "the scene's picture as it should be"},
        {"--picture", "P.exr", "the picture; of a folder of scenes the folder of their pictures, NAME.exr or NAME.png"},
        {"--samples", "N", "the picture is sampled at random, N rays a pixel: judged by the reference's variances"},
        {"--reference-dir", "DIR", "the scenes and references of a folder: reference_images/scenes"},
        {"--chapter", "NN", "of these the chapter's"},
        {"--renderer", "PROGRAM", "grade a whole renderer, run as PROGRAM SCENE.toml OUT.exr"},
        {"--png", "", "the renderer writes OUT.png"},
        {"--seconds", "S", "of processor time that the renderer gets for each scene (default: 60)"}}};

Isolation official_isolation(const Arguments& arguments) {
    if (arguments.has("--isolation")) return isolation_at(static_cast<Level>(arguments.integer("--isolation", 2, 3)));
    const auto best = best_isolation();
    return best.level >= Level::system_calls ? best : isolation_at(Level::system_calls);
}

std::uint64_t official_seed(const Arguments& arguments, const Exercise& exercise) {
    if (const auto seed = seed_if_given(arguments)) return *seed;
    if (const auto key = arguments.text_if_given("--key"))
        return seed_by_key(read_course_key(*key), exercise.folder, arguments.text_if_given("--student").value_or(""));
    return fresh_seed();
}

// What the result must not replace.
std::vector<fs::path> inputs_of(const Arguments& arguments) {
    auto inputs = arguments.given({"--submission", "--picture"});
    // A student's link could lead to the folder of the result. It is not followed, here neither.
    std::erase_if(inputs, [](const fs::path& input) { return !fault_of_link(input).empty(); });
    const auto of_the_course = arguments.given({"--key", "--scene", "--reference", "--reference-dir", "--renderer"});
    inputs.insert(inputs.end(), of_the_course.begin(), of_the_course.end());
    return inputs;
}

bool asks_for_pictures(const Arguments& arguments) {
    return arguments.has("--scene") || arguments.has("--reference-dir");
}

Grade graded(const Arguments& arguments) {
    const auto most = points_asked_for(arguments);
    if (asks_for_pictures(arguments)) return graded_pictures(arguments, official_isolation(arguments), most);
    const auto& exercise = grading::exercise(arguments.text("NN"));
    const Terms terms{official_seed(arguments, exercise), official_isolation(arguments), most,
                      arguments.text_if_given("--prepared").value_or("")};
    auto grade = official_grade(exercise, arguments.text("--submission"), terms);
    grade.student = arguments.text_if_given("--student").value_or("");
    return grade;
}

}  // namespace

Hundredths points_asked_for(const Arguments& arguments) {
    constexpr long long most_points = 100'000;
    return static_cast<Hundredths>(100 * arguments.integer("--points", 1, most_points));
}

ExitCode grade_command(const std::vector<std::string>& words) {
    const auto arguments = parse(grade_command_line, words);
    refuse_idle_options(arguments);
    if (arguments.has("--merge")) return merge_reports(arguments);
    if (arguments.has("--class")) return grade_class(arguments);
    const auto& format = format_of(arguments.text_if_given("--format").value_or("text"));
    const auto output = arguments.text("--output");
    if (arguments.has("NN") && arguments.all("NN").size() > 1)
        throw Error("expected one exercise, found " + std::to_string(arguments.all("NN").size()));
    // Refused before anything is written: the result would replace what is to be graded, or what it is graded by.
    const Outputs planned({.files = {output}, .inputs = inputs_of(arguments)});
    Grade internal{.exercise = asks_for_pictures(arguments) ? "pictures" : arguments.text("NN")};
    // A grader that dies, or is killed, leaves this, and never a result of another time.
    if (output != "-") write_file(output, format.text_of(internal));
    try {
        const auto grade = graded(arguments);
        write_file(output, format.text_of(grade));
        return grade.passed() ? ExitCode::as_it_should_be : ExitCode::negative;
    } catch (const std::exception& error) {
        internal.summary = error.what();
        write_file(output, format.text_of(internal));
        throw;
    }
}

}  // namespace raylab
