#include "handout.h"
#include "commands.h"

#include "raylab/base/command_line.h"
#include "raylab/base/error.h"
#include "raylab/base/outputs.h"
#include "raylab/base/printable.h"

#include <filesystem>

namespace raylab {

namespace {

const CommandLine handout_command_line{
    .program = "raylab handout",
    .about = "Writes what a course gives out: the exercises, and a program that checks them, without the references' "
             "sources.",
    .positionals = {{"DIR", "a folder that does not exist yet"}}};

}  // namespace

ExitCode handout_command(const std::vector<std::string>& words) {
    const auto arguments = parse(handout_command_line, words);
    const std::filesystem::path folder = arguments.text("DIR");
    if (std::filesystem::exists(folder)) throw Error({folder.string()}, "a folder that does not exist yet", "one");
    Outputs outputs({.folders = {folder}});
    outputs.naming_folders([&] { grading::write_handout(outputs.staged(folder).path); });
    outputs.say("the handout: " + printable(folder.string()) + ", to be tried with ./raylab check 02 in it\n");
    outputs.commit();
    return ExitCode::as_it_should_be;
}

}  // namespace raylab
