#include "chapter_programs.h"

#include "raylab/base/error.h"
#include "raylab/base/numbered_name.h"
#include "raylab/base/print.h"
#include "raylab/base/program.h"
#include "raylab/base/read_json.h"
#include "raylab/report/provenance.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace raylab {

namespace fs = std::filesystem;

namespace {

bool is_chapter_folder(const std::string& name) {
    const auto digit = [&](std::size_t at) { return std::isdigit(static_cast<unsigned char>(name[at])) != 0; };
    return name.size() > 3 && digit(0) && digit(1) && name[2] == '_';
}

void ask(ChapterProgram& chapter) {
    const auto answer = run_process(chapter.path, {"--list"}, {.timeout = 60});
    if (!answer.succeeded()) throw Error(failure_of(chapter.folder + " --list", answer));
    const auto list = json_from_text(answer.output, chapter.folder + " --list");
    chapter.title = list.at("title");
    chapter.question = list.at("question");
    chapter.questions = list.at("questions").get<std::vector<std::string>>();
    chapter.cases = list.at("cases").get<std::vector<std::string>>();
}

}  // namespace

std::vector<ChapterProgram> built_chapters() {
    std::vector<ChapterProgram> chapters;
    std::error_code none_built;
    for (const auto& entry : fs::directory_iterator(build_folder() / "chapters", none_built)) {
        const auto folder = entry.path().filename().string();
        if (is_chapter_folder(folder) && fs::is_regular_file(entry.path() / folder))
            chapters.push_back({folder, entry.path() / folder});
    }
    std::ranges::sort(chapters, {}, &ChapterProgram::folder);
    return chapters;
}

std::vector<ChapterProgram> listed_chapters() {
    auto chapters = built_chapters();
    for (auto& chapter : chapters) ask(chapter);
    return chapters;
}

namespace {

// In a handout (raylab handout) there are lessons without programs.
void refuse_in_handout(const std::string& name) {
    if (!fs::exists(source_folder() / "handout.txt")) return;
    std::vector<std::string> lessons;
    for (const auto& entry : fs::directory_iterator(source_folder() / "chapters")) {
        const auto folder = entry.path().filename().string();
        if (means_folder(name, folder))
            throw Error(
                fmt::format("expected a chapter's program, but this is a handout, without the chapters' programs: "
                            "chapters/{}/README.md is the lesson, and ./raylab render draws its scenes",
                            folder));
        lessons.push_back(folder);
    }
    std::ranges::sort(lessons);
    throw Error(fmt::format("expected a chapter's lesson, as this is a handout: {}; found {}", fmt::join(lessons, ", "),
                            with_suggested_folder(name, lessons)));
}

}  // namespace

ChapterProgram built_chapter(const std::string& name) {
    refuse_in_handout(name);
    std::vector<std::string> known;
    for (const auto& chapter : built_chapters()) {
        if (means_folder(name, chapter.folder)) return chapter;
        known.push_back(chapter.folder);
    }
    throw Error(fmt::format("expected a chapter: {}; found {}",
                            known.empty() ? "none is built" : fmt::format("{}", fmt::join(known, ", ")),
                            with_suggested_folder(name, known)));
}

ProcessResult run_for_us(const fs::path& program, const std::vector<std::string>& words, ProcessOptions options) {
    options.errors = ProcessOptions::Stream::passed_on;
    const auto result = run_process(program, words, options);
    const bool exited = result.end == ProcessResult::End::exited;
    const bool reader_gone = result.end == ProcessResult::End::signalled && result.code == SIGPIPE;
    if (reader_gone || (exited && result.code == static_cast<int>(ExitCode::could_not))) throw EndQuietly{};
    if (!exited || result.code > static_cast<int>(ExitCode::could_not))
        throw Error(failure_of(program.filename().string(), result));
    return result;
}

}  // namespace raylab
