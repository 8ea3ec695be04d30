#include "workplace.h"

#include "prepared_header.h"

#include "raylab/base/file.h"
#include "raylab/report/provenance.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace raylab::grading {

namespace fs = std::filesystem;

std::vector<std::string> included_headers(const fs::path& file) {
    static const std::regex directive(R"re(^#include "(raylab/[^"]+)")re");
    std::vector<std::string> found;
    std::istringstream lines(read_file(file));
    std::smatch match;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_search(line, match, directive)) found.push_back(match[1]);
    return found;
}

namespace {

std::vector<fs::path> files_that_come_with(const Exercise& exercise) {
    const auto folder = source_folder() / "exercises" / exercise.folder;
    std::vector<fs::path> files{folder / (exercise.slot + ".cpp")};
    for (const auto* kind : {"mistakes", "right"})
        for (const auto& entry : fs::directory_iterator(folder / kind)) files.push_back(entry.path());
    return files;
}

}  // namespace

std::vector<std::string> visible_headers(const Exercise& exercise) {
    std::vector<std::string> visible;
    // A handout has no answers to look into, and lists the headers instead.
    if (const auto list = source_folder() / "exercises" / exercise.folder / headers_file; fs::exists(list)) {
        std::istringstream lines(read_file(list));
        for (std::string line; std::getline(lines, line);) visible.push_back(line);
        return visible;
    }
    const auto add = [&](const fs::path& file) {
        for (auto& header : included_headers(file))
            if (std::ranges::find(visible, header) == visible.end()) visible.push_back(std::move(header));
    };
    for (const auto& file : files_that_come_with(exercise)) add(file);
    // The list grows while it is walked, by what its own headers include.
    for (std::size_t i = 0; i < visible.size(); ++i) add(source_folder() / "lib" / visible[i]);
    std::ranges::sort(visible);
    return visible;
}

Workplace::Workplace(const Exercise& exercise, const Isolation& isolation, const fs::path& prepared)
    : slot_(exercise.slot), isolation_(isolation) {
    for (const auto& header : visible_headers(exercise)) {
        fs::create_directories((headers() / header).parent_path());
        fs::copy_file(source_folder() / "lib" / header, headers() / header);
    }
    if (!prepared.empty()) share_prepared_header(exercise, prepared, headers());
}

}  // namespace raylab::grading
