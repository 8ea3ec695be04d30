#include "watched_exercise.h"

#include "hints.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/base/read_json.h"
#include "raylab/base/temporary.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/image/picture_files/terminal_picture.h"
#include "raylab/report/provenance.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <vector>

namespace raylab {

namespace fs = std::filesystem;

namespace {

constexpr double check_patience = 300;   // seconds for one check
constexpr std::size_t shown_lines = 20;  // of a compiler's messages
constexpr int preview_columns = 78;      // of a terminal, which seldom has fewer than 80

fs::path folder_of(const grading::Exercise& exercise) { return source_folder() / "exercises" / exercise.folder; }

std::string first_messages(const std::string& text) {
    std::istringstream lines(text);
    std::string result;
    std::size_t count = 0;
    for (std::string line; count < shown_lines && std::getline(lines, line); ++count) result += line + "\n";
    return result;
}

// Groups that are not all right, each on a line; the first wrong case is told in front of them.
std::string failures_in(const nlohmann::json& verdict) {
    std::string text;
    if (const auto& wrong = verdict.at("first_wrong"); wrong.is_object())
        text =
            fmt::format("Case {}, {}:\n{}\n  expected   {}\n  got        {}\n\n", wrong.at("case").get<std::size_t>(),
                        wrong.at("group").get<std::string>(), wrong.at("story").get<std::string>(),
                        wrong.at("expected").get<std::string>(), wrong.at("got").get<std::string>());
    for (const auto& group : verdict.at("groups")) {
        const auto right = group.at("right").get<std::size_t>(), total = group.at("total").get<std::size_t>();
        if (group.at("graded") == true && right < total)
            text += fmt::format("  ✗ {}: {} of {}\n", group.at("group").get<std::string>(), right, total);
    }
    return text + fmt::format("{} of {} cases right. h: a hint, a: everything\n",
                              verdict.at("right").get<std::size_t>(), verdict.at("total").get<std::size_t>());
}

}  // namespace

WatchedExercise::WatchedExercise(const grading::Exercise& exercise)
    : WatchedExercise(exercise, folder_of(exercise) / (exercise.slot + ".cpp")) {}

WatchedExercise::WatchedExercise(const grading::Exercise& exercise, const fs::path& file)
    : exercise_(&exercise), file_(file) {}

std::string WatchedExercise::file() const { return fs::proximate(file_).string() + ":1"; }

std::string WatchedExercise::readme() const { return fs::proximate(folder_of(*exercise_) / "README.md").string(); }

bool WatchedExercise::is_begun() const { return read_file(file_).find("Unfinished{}") == std::string::npos; }

bool WatchedExercise::look() {
    std::error_code gone;  // an editor may put a new file in the old one's place
    const auto saved = fs::last_write_time(file_, gone);
    if (gone || saved == saved_) return false;
    saved_ = saved;
    const ScratchFolder scratch;
    const auto data = scratch.path() / "verdict.json";
    const auto picture = scratch.path() / "preview.png";
    const auto shows = terminal_pictures_of_standard_output();
    std::vector<std::string> words{"check",          exercise_->folder, "--answer",   file_.string(),
                                   "--verdict-only", "--json",          data.string()};
    if (shows != TerminalPictures::none) words.insert(words.end(), {"--preview", picture.string()});
    const auto check = run_process("/proc/self/exe", words, {.timeout = check_patience});
    at_length_ = check.output + check.errors;
    passed_ = check.succeeded();
    const auto verdict = fs::exists(data) ? read_json(data) : nlohmann::ordered_json();
    const bool judged = verdict.is_object() && verdict.contains("groups");
    in_short_ = passed_ ? "PASSED\n" : judged ? failures_in(verdict) : first_messages(at_length_);
    preview_ = fs::exists(picture) ? terminal_picture(read_image(picture), shows, preview_columns) : "";
    hint_.clear();
    if (!judged || !verdict.at("hint_id").is_string()) return true;
    const auto hints = read_hints(*exercise_);
    if (const auto* text = hints.text(verdict.at("hint_id").get<std::string>()))
        hint_ = *text + "\n(" + verdict.at("evidence").get<std::string>() + ")\n";
    return true;
}

std::string WatchedExercise::hint(std::size_t which) const {
    if (!hint_.empty() && which == 0) return "\n" + hint_;
    const auto hints = read_hints(*exercise_);
    const auto level = std::min(which - (hint_.empty() ? 0 : 1), hints.levels.size() - 1);
    return fmt::format("\nHint {} of {}\n\n{}\n", level + 1, hints.levels.size(), hints.levels[level]);
}

}  // namespace raylab
