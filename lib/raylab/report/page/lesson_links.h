#pragma once

#include "raylab/report/chapter_run.h"

#include <filesystem>
#include <string>
#include <vector>

namespace raylab {

/// Where a lesson's links lead in its page: to other chapters' pages, to the web, and to copies of the repository's
/// files beside the page, which so can be given away alone.
class LessonLinks {
public:
    LessonLinks(const std::filesystem::path& readme, ChapterRun::Place place);

    /// The page's target for a target in the lesson; empty where the page has none. It throws an Error where the
    /// repository has no such file.
    std::string target(const std::string& link);

    /// The repository's file to which one of the targets leads.
    const std::filesystem::path& file(const std::string& target) const;

    const std::vector<std::filesystem::path>& sources() const { return sources_; }

private:
    std::filesystem::path readme_;
    ChapterRun::Place place_;
    std::vector<std::filesystem::path> sources_;
};

/// The name that the copy of a source has in the page's folder: "source/whitted_tracer.h.txt".
std::string source_copy(const std::filesystem::path& source);

}  // namespace raylab
