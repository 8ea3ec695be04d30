#include "catch.h"

#include "glossary.h"

#include "raylab/base/file.h"

#include <algorithm>
#include <filesystem>
#include <regex>

// The lessons of chapters 01 to 13, as CONTRIBUTING.md describes them: their parts, and that nothing is used before it
// is defined.

using namespace raylab;
using namespace raylab::lessons;
namespace fs = std::filesystem;

namespace {

const fs::path chapters = fs::path(RAYLAB_SOURCE) / "chapters";

// The most words that a core may have: what can be read in about ten minutes.
constexpr std::size_t longest_core = 1900;

struct Chapter {
    std::string folder, title, question;
    NamedLesson lesson;
    std::string number() const { return folder.substr(0, 2); }
};

Chapter chapter_in(const fs::path& folder) {
    static const std::regex names("\\.title = \\{\"([^\"]*)\",\\s*\"([^\"]*)\",\\s*\"([^\"]*)\"\\}");
    const std::string program = read_file(folder / "main.cpp");
    std::smatch match;
    if (!std::regex_search(program, match, names)) FAIL("no .title in " << folder / "main.cpp");
    return {match[1], match[2], match[3], {folder.filename().string(), lesson_text(read_file(folder / "README.md"))}};
}

std::vector<Chapter> chapters_in_order() {
    std::vector<Chapter> found;
    for (const auto& entry : fs::directory_iterator(chapters))
        if (fs::exists(entry.path() / "main.cpp") && entry.path().filename() != "program")
            found.push_back(chapter_in(entry.path()));
    std::ranges::sort(found, {}, &Chapter::folder);
    return found;
}

std::vector<NamedLesson> book() {
    std::vector<NamedLesson> lessons;
    for (const Chapter& chapter : chapters_in_order()) lessons.push_back(chapter.lesson);
    return lessons;
}

void check_none(const Complaints& complaints) {
    for (const auto& complaint : complaints) FAIL_CHECK(complaint);
}

}  // namespace

TEST_CASE("a lesson has its program's title and question, and all parts in their order") {
    CHECK(!chapters_in_order().empty());
    for (const Chapter& chapter : chapters_in_order()) {
        INFO(chapter.folder);
        const LessonText& text = chapter.lesson.text;
        CHECK(chapter.folder == chapter.lesson.name);
        check_none(title_complaints(text, chapter.number(), chapter.title, chapter.question));
        check_none(part_complaints(text));
        check_none(question_complaints(text));
        check_none(experiment_complaints(text));
        check_none(summary_complaints(text));
        check_none(figure_complaints(text));
        check_none(numbering_complaints(text));
        CHECK(core_words(text) <= longest_core);
        for (const auto& file : figure_files(text)) {
            INFO(file);
            CHECK(fs::exists(chapters / chapter.folder / file));
        }
    }
}

TEST_CASE("every term is defined once, in bold, has an entry, and is used nowhere before") {
    for (const NamedLesson& lesson : book()) check_none(definition_complaints(lesson));
    check_none(early_use_complaints(book()));
}

TEST_CASE("every symbol of a formula of chapters 01 to 07 is in a list up to there") {
    std::vector<NamedLesson> so_far;
    for (const Chapter& chapter : chapters_in_order()) {
        if (chapter.number() > "07") break;
        so_far.push_back(chapter.lesson);
        check_none(symbol_complaints(so_far));
    }
}
