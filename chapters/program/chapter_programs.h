#pragma once

#include "raylab/base/process.h"

#include <filesystem>
#include <string>
#include <vector>

// The chapters are programs of their own, beside this one: found in the build folder, asked through --list.

namespace raylab {

/// A chapter's program and what it says of itself.
struct ChapterProgram {
    std::string folder;  // "02_spheres_and_quadrics"
    std::filesystem::path path;
    std::string title = {}, question = {};
    std::vector<std::string> questions = {}, cases = {};  // the names that `chart` and `stability` take
};

/// All chapters of this build, in their order, asked nothing yet.
std::vector<ChapterProgram> built_chapters();

/// All chapters of this build, each asked for its questions and cases.
std::vector<ChapterProgram> listed_chapters();

/// The chapter "2", "02" or "02_spheres_and_quadrics". Error names those there are.
ChapterProgram built_chapter(const std::string& name);

/// Runs a program of the lab, its stderr being ours, for as long as it takes: it has said why where it could not, and
/// then EndQuietly is thrown. Error where it did not end by itself.
ProcessResult run_for_us(const std::filesystem::path& program, const std::vector<std::string>& words,
                         ProcessOptions options = {});

}  // namespace raylab
