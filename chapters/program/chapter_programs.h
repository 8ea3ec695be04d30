#pragma once

#include "raylab/base/process.h"

#include <filesystem>
#include <string>
#include <vector>

// The chapters are separate programs: they are found in the build folder and queried through --list.

namespace raylab {

/// A chapter's program, with its answer to --list.
struct ChapterProgram {
    std::string folder;  // "02_spheres_and_quadrics"
    std::filesystem::path path;
    std::string title = {}, question = {};
    std::vector<std::string> questions = {}, cases = {};  // the names that `chart` and `stability` take
};

/// All chapters of this build, in their order, without running them.
std::vector<ChapterProgram> built_chapters();

/// All chapters of this build, each run for its questions and cases.
std::vector<ChapterProgram> listed_chapters();

/// The chapter that a word means (base/numbered_name.h). The Error lists those that exist.
ChapterProgram built_chapter(const std::string& name);

/// Runs a program of the lab, which shares this program's stderr and has no time limit. Where it fails it has printed
/// the reason itself, so EndQuietly is thrown; where it is ended by a signal, an Error.
ProcessResult run_for_us(const std::filesystem::path& program, const std::vector<std::string>& words,
                         ProcessOptions options = {});

}  // namespace raylab
