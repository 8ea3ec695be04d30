#include "commands.h"
#include "retired_names.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/nearest_name.h"

#include <algorithm>
#include <cstdio>

namespace {

using namespace raylab;

const std::vector<Command>& commands() {
    static const std::vector<Command> all = {
        {"tour", "run every chapter and write the lab book", tour_command},
        {"chapter", "run one chapter", chapter_command},
        {"slides", "write a chapter as a deck, one self-contained file", slides_command},
        {"chart", "measure speed against accuracy of one question's methods", chart_command},
        {"stability", "run the cases in which methods fail: expected, observed, verdict", stability_command},
        {"render", "draw a picture of any scene", render_command},
        {"merge", "add parts of a picture, rendered one by one, to the whole", merge_command},
        {"radiosity", "compute the light between diffuse surfaces, and show it from anywhere", radiosity_command},
        {"form-factor", "tell how much of one object's light arrives at another", form_factor_command},
        {"needs", "tell what a scene needs, what is left out, and why", needs_command},
        {"tree", "draw the tree of all rays of a pixel, or tell where two trees differ", tree_command},
        {"compare", "compare two pictures and tell where they differ", compare_command},
        {"trace", "trace the rays of a file through a mesh: what each hits, and how fast", trace_command},
        {"bench", "compare raylab's structures with Embree's and CGAL's: speed and memory", bench_command},
        {"export", "write a scene for another renderer (POV-Ray)", export_command},
        {"doctor", "show what this machine has, and what is missing", doctor_command},
        {"check", "compile and judge your answer to an exercise", check_command},
        {"watch", "check your answer each time you save it, and go on to the next exercise", watch_command},
        {"grade", "grade a submission, or a class, officially", grade_command},
        {"handout", "write what a course gives out: exercises that check themselves", handout_command},
        {"package", "write what a course's machine installs to grade", package_command},
    };
    return all;
}

std::string help() {
    std::string text = "raylab: a step-by-step lab for ray tracing and global illumination\n\n";
    for (const auto& command : commands())
        text += "  raylab " + command.name + std::string(14 - std::min<std::size_t>(13, command.name.size()), ' ') +
                command.about + "\n";
    return text + "\nEvery command has --help.\n";
}

std::vector<std::string> names() {
    std::vector<std::string> names{"help"};
    for (const auto& command : commands()) names.push_back(command.name);
    return names;
}

ExitCode run(const std::vector<std::string>& words) {
    if (words.empty() || words[0] == "help" || words[0] == "--help" || words[0] == "-h") throw HelpWanted{help()};
    const auto found = std::ranges::find(commands(), words[0], &Command::name);
    if (found == commands().end())
        throw Error("expected a command (raylab help lists them), found " + with_suggestion(words[0], names()));
    refuse_retired_names(words);
    return found->run({words.begin() + 1, words.end()});
}

}  // namespace

int main(int argc, char** argv) {
    return run_program([&] { return run(words(argc, argv)); });
}
