#include "commands.h"
#include "lead_home.h"
#include "practice/ask_quiz.h"
#include "practice/yours_and_reference.h"

#include "asking.h"
#include "compiling.h"
#include "hints.h"
#include "judging.h"
#include "submission.h"

#include "raylab/base/command_line.h"
#include "raylab/base/common_options.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/outputs.h"
#include "raylab/base/print.h"
#include "raylab/base/process.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/json_text.h"
#include "raylab/report/provenance.h"

#include <fmt/format.h>

#include <filesystem>
#include <random>

namespace raylab {

namespace fs = std::filesystem;
using namespace grading;

namespace {

const CommandLine check_command_line{
    .program = "raylab check",
    .about = "Compiles your answer to an exercise, judges it, and shows the result.",
    .positionals = {{"NN", "the exercise, by number or folder"}},
    .options = {
        {"--answer", "FILE", "your file (default: exercises/NN_name/...cpp)"},
        {"--hint", "LEVEL", "print a hint instead of a verdict: 1 the idea, 2 where to look, 3 nearly the code"},
        {"--quiz", "", "ask the questions of the exercise's chapter instead, and judge your answers"},
        {"--seed", "S", "the seed of the cases, to repeat a check (default: a new one)"},
        {"--isolation", "LEVEL",
         "1, 2 or 3: how far your program is kept apart (default: the best that this machine has)"},
        {"--verdict-only", "", "draw no pictures and no chart"},
        {"--preview", "FILE", "yours and the reference's picture alone, as PNG; also with --verdict-only"},
        {"-o,--out", "DIR", "the folder for pictures and chart", "out/check"},
        {"--json", "FILE", "the verdict as JSON; - is standard output"}}};

void draw_pictures(const Exercise& exercise, const Workplace& workplace, const StagedFolder& folder, Outputs& outputs) {
    const auto* const name = "yours_and_reference.png";
    const auto [image, missing] = yours_and_reference(exercise, workplace);
    write_image(image, folder.path / name);
    outputs.say(fmt::format("  Picture ({}): yours,{} the reference: {}\n{}", exercise.picture.about,
                            exercise.picture.draw ? "" : " where it differs,", (folder.named / name).string(),
                            missing));
}

// The first wrong case, with the answer to it.
void draw_case(const Exercise& exercise, const WrongCase& wrong, const StagedFolder& folder, Outputs& outputs) {
    const auto* const name = "first_wrong_case.svg";
    write_svg(exercise.sketch(wrong.question, wrong.answer), folder.path / name);
    outputs.say(fmt::format("  The first wrong case, with your answer in it: {}\n", (folder.named / name).string()));
}

// The chapter draws its own chart, with the student's function among its methods.
void draw_chart(const Exercise& exercise, const Workplace& workplace, const StagedFolder& folder, Outputs& outputs) {
    if (!fs::exists(build_folder() / "chapters" / exercise.chapter))
        return outputs.say("  No chart: this is a handout, without the chapters' programs\n");
    link_chapter(exercise, workplace);
    const auto charts = workplace.path() / "charts";  // the only folder in which that program can write
    const auto drawn = run_isolated(workplace.isolated(), {Work::draw, 15}, workplace.chapter(),
                                    {"--yours", exercise.slot, "--quick", "--only", "charts", "--question",
                                     exercise.chart, "--out", charts.string()});
    if (!drawn.succeeded()) {
        outputs.say("  No chart: " + failure_of("the chapter with your function in it", drawn) + "\n");
        return;
    }
    fs::copy(charts, folder.path, fs::copy_options::recursive);
    outputs.say(fmt::format("  Chart (`yours` among chapter {}'s methods): {}\n", exercise.chapter.substr(0, 2),
                            (folder.named / exercise.chapter / (exercise.chart + ".svg")).string()));
}

ExitCode show_hint(const Exercise& exercise, const Arguments& arguments) {
    const auto hints = read_hints(exercise);
    const auto level = arguments.integer("--hint", 1, static_cast<long long>(hints.levels.size()));
    print_text(fmt::format("Hint {} of {}\n\n{}\n", level, hints.levels.size(),
                           hints.levels[static_cast<std::size_t>(level - 1)]));
    return ExitCode::as_it_should_be;
}

void draw(const Exercise& exercise, const Workplace& workplace, const Verdict& verdict, const StagedFolder& folder,
          Outputs& outputs) {
    if (exercise.sketch && verdict.first_wrong) draw_case(exercise, *verdict.first_wrong, folder, outputs);
    draw_pictures(exercise, workplace, folder, outputs);
    // The few rays of a chart may all be ones that a wrong function answers, too.
    if (!exercise.chart.empty() && verdict.passed()) draw_chart(exercise, workplace, folder, outputs);
    if (exercise.traced && !verdict.passed()) outputs.say(lead_home(exercise, workplace, folder));
}

// A new one for each check: a table of answers to known cases answers nothing.
std::uint64_t seed_of(const Arguments& arguments) {
    const auto given = seed_if_given(arguments);
    return given ? *given : std::random_device()();
}

Isolation isolation_of(const Arguments& arguments) {
    if (!arguments.has("--isolation")) return best_isolation();
    return isolation_at(static_cast<Level>(arguments.integer("--isolation", 1, 3)));
}

std::string in_words(const Conditions& conditions) {
    return fmt::format("seed {}, isolation {}", conditions.seed, to_string(conditions.isolation));
}

ExitCode not_yet(const Arguments& arguments, Outputs& outputs, const std::string& json) {
    if (const auto file = arguments.text_if_given("--json")) write_json(json, outputs[*file]);
    outputs.commit();
    return ExitCode::negative;
}

}  // namespace

ExitCode check_command(const std::vector<std::string>& words) {
    const auto arguments = parse(check_command_line, words);
    const auto& exercise = grading::exercise(arguments.text("NN"));
    if (arguments.has("--hint")) return show_hint(exercise, arguments);
    if (arguments.has("--quiz")) return ask_quiz(exercise);

    const Conditions conditions{seed_of(arguments), isolation_of(arguments)};

    // The other files are named from where the person stands.
    const auto own = fs::proximate(source_folder() / "exercises" / exercise.folder / (exercise.slot + ".cpp"));
    const auto file = arguments.text_if_given("--answer").value_or(own.string());
    const bool quiet = arguments.text_if_given("--json") == "-";
    const auto say = quiet ? print_note : print_text;

    const bool drawn = !arguments.has("--verdict-only") && !quiet;
    const auto folder = fs::path(arguments.text("--out")) / exercise.folder;
    Outputs outputs({.files = arguments.given({"--json", "--preview"}),
                     .folders = drawn ? std::vector{folder} : std::vector<fs::path>{},
                     .inputs = {file}});

    say("Exercise " + exercise.folder + ": " + file + "\n");
    if (const auto handed_in = find_submission(exercise, file); fs::exists(file) && !handed_in.fault.empty()) {
        say("\nNOT YET: " + handed_in.fault + "\n");
        return not_yet(
            arguments, outputs,
            to_json(exercise, Answers{.end = Answers::End::incomplete, .reason = handed_in.fault}, conditions));
    }
    const Workplace workplace(exercise, conditions.isolation);
    const auto compiled = compile(exercise, workplace, file);
    if (!compiled.succeeded) {
        say(compiled.diagnostics + "\nNOT YET: the file " +
            (compiled.refused ? "is not taken as an answer" : "does not compile") + "\n");
        return not_yet(
            arguments, outputs,
            to_json(exercise, Answers{.end = Answers::End::incomplete, .reason = "does not compile"}, conditions));
    }
    if (!compiled.diagnostics.empty()) say("  The compiler warns:\n" + compiled.diagnostics + "\n");
    const auto [cases, answers, verdict, ended] = ask(exercise, workplace, conditions.seed);
    if (!ended.empty()) {
        say(fmt::format("\n  {}\n  {}\nNOT YET\n", ended, in_words(conditions)));
        return not_yet(arguments, outputs, to_json(exercise, answers, conditions));
    }
    if (!answers.printed.empty()) say("  It printed:\n" + quoted(answers.printed) + "\n");
    say(fmt::format("  compiled in {:.1f} s, {} cases answered in {:.2f} s; {}\n\n{}", compiled.seconds,
                    answers.values.size() / exercise.outputs, answers.seconds, in_words(conditions),
                    to_text(exercise, verdict, read_hints(exercise))));
    flush_standard_output();
    if (const auto json = arguments.text_if_given("--json"))
        write_json(to_json(exercise, verdict, conditions), outputs[*json]);
    if (const auto preview = arguments.text_if_given("--preview")) {
        const auto [image, missing] = yours_and_reference(exercise, workplace);
        write_image(image, outputs[*preview]);
        if (!drawn && !missing.empty()) say(missing);
    }
    if (drawn) outputs.naming_folders([&] { draw(exercise, workplace, verdict, outputs.staged(folder), outputs); });
    outputs.commit();
    return verdict.passed() ? ExitCode::as_it_should_be : ExitCode::negative;
}

}  // namespace raylab
