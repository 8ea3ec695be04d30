#include "commands.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"

#include <algorithm>
#include <cstdio>

namespace {

using namespace raylab;

const std::vector<Command>& commands() {
    static const std::vector<Command> all = {
        {"tour", "every chapter, and the lab book of them all", tour_command},
        {"chapter", "one chapter", chapter_command},
        {"chart", "speed against accuracy of one question's methods", chart_command},
        {"stability", "the cases where methods fail: expected, observed, verdict", stability_command},
        {"render", "a picture of any scene", render_command},
        {"needs", "what a scene needs, what is left out, and why", needs_command},
        {"tree", "the tree of all rays that make a pixel, or where two trees part", tree_command},
        {"compare", "are two pictures the same, and where not?", compare_command},
        {"trace", "the rays of a file through a mesh: what each hits, and how fast", trace_command},
        {"bench", "our structures' speed and memory beside Embree's and CGAL's", bench_command},
        {"export", "a scene for another renderer (POV-Ray)", export_command},
        {"doctor", "what this machine has, and what is missing", doctor_command},
        {"check", "compile and judge your answer to an exercise", check_command},
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

ExitCode run(const std::vector<std::string>& words) {
    if (words.empty() || words[0] == "help" || words[0] == "--help" || words[0] == "-h") throw HelpWanted{help()};
    const auto found = std::ranges::find(commands(), words[0], &Command::name);
    if (found == commands().end())
        throw Error("expected a command (see raylab help), found '" + words[0] + "'");
    return found->run({words.begin() + 1, words.end()});
}

}  // namespace

int main(int argc, char** argv) {
    return run_program([&] { return run(words(argc, argv)); });
}
