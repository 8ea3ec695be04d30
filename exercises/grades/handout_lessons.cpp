#include "handout_lessons.h"

#include "exercise.h"
#include "quiz_seal.h"

#include "raylab/base/file.h"
#include "raylab/report/provenance.h"

#include <regex>
#include <set>
#include <string>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

void copy_scenes(const fs::path& handout) {
    const auto chapters = source_folder() / "chapters";
    for (const auto& entry : fs::recursive_directory_iterator(chapters)) {
        if (entry.path().extension() != ".toml") continue;
        const auto copy = handout / "chapters" / entry.path().lexically_relative(chapters);
        fs::create_directories(copy.parent_path());
        fs::copy(entry.path(), copy);
    }
}

// The text with the words of a link alone, where it leads to a file that is not there.
std::string without_dead_links(const std::string& text, const fs::path& folder) {
    static const std::regex link(R"((!?)\[([^\]\n]*)\]\(((?!http|#)[^) #]*[./][^) #]*)[^)\n]*\))");
    std::string kept;
    auto rest = text.begin();
    for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end; ++match) {
        const auto& found = *match;
        if (found[1].length() != 0 || fs::exists(folder / found[3].str())) continue;
        kept.append(rest, found[0].first).append(found[2].first, found[2].second);
        rest = found[0].second;
    }
    return kept.append(rest, text.end());
}

std::set<std::string> chapters_with_exercises() {
    std::set<std::string> chapters;
    for (const auto& exercise : exercises()) chapters.insert(exercise.chapter);
    return chapters;
}

}  // namespace

void write_lessons(const fs::path& handout) {
    copy_scenes(handout);
    const auto chapters = chapters_with_exercises();
    for (const auto& chapter : chapters) {
        const auto from = source_folder() / "chapters" / chapter, to = handout / "chapters" / chapter;
        write_file(to / "README.md", without_answers(read_file(from / "README.md")));
        if (fs::exists(from / "pictures")) fs::copy(from / "pictures", to / "pictures", fs::copy_options::recursive);
    }
    // They link to each other.
    for (const auto& chapter : chapters) {
        const auto lesson = handout / "chapters" / chapter / "README.md";
        write_file(lesson, without_dead_links(read_file(lesson), lesson.parent_path()));
    }
}

}  // namespace raylab::grading
