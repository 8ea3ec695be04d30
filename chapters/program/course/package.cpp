#include "package.h"
#include "commands.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/outputs.h"
#include "raylab/base/printable.h"

#include <filesystem>

namespace raylab {

namespace {

const CommandLine package_command_line{
    .program = "raylab package",
    .about = "Writes what a course's machine installs to grade an exercise: scripts, and a handout to grade with.",
    .positionals = {{"NN", "the exercise, by number or folder"}},
    .options = {{"--for", "MACHINE", "gradescope, github or prairielearn"},
                {"-o,--output", "DIR", "a folder that does not exist yet"}}};

}  // namespace

ExitCode package_command(const std::vector<std::string>& words) {
    const auto arguments = parse(package_command_line, words);
    const auto& exercise = grading::exercise(arguments.text("NN"));
    const std::filesystem::path folder = arguments.text("--output");
    if (std::filesystem::exists(folder)) throw Error({folder.string()}, "a folder that does not exist yet", "one");
    Outputs outputs({.folders = {folder}});
    outputs.naming_folders(
        [&] { grading::write_package(exercise, arguments.text("--for"), outputs.staged(folder).path); });
    outputs.say("the package: " + printable((folder / "README.md").string()) + " says how it is installed\n");
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
