#include "catch.h"

#include "raylab/base/file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

// The project's Markdown: a folder that needs a README has one, and whatever file a text names is there.

namespace fs = std::filesystem;

namespace {

const fs::path root = RAYLAB_SOURCE;

bool is_ours(const fs::path& folder) {
    const std::string name = folder.filename();
    return !name.starts_with('.') && name != "build" && name != "out";
}

// All files below a folder but those of version control and builds, and the folders among them.
std::vector<fs::directory_entry> entries(const fs::path& folder) {
    std::vector<fs::directory_entry> found;
    for (auto at = fs::recursive_directory_iterator(folder); at != fs::recursive_directory_iterator(); ++at) {
        if (at->is_directory() && !is_ours(at->path()))
            at.disable_recursion_pending();
        else
            found.push_back(*at);
    }
    return found;
}

std::vector<fs::path> texts() {
    std::vector<fs::path> found;
    for (const auto& entry : entries(root))
        if (entry.path().extension() == ".md") found.push_back(entry.path());
    return found;
}

std::ptrdiff_t files_in(const fs::path& folder) {
    return std::count_if(fs::directory_iterator(folder), fs::directory_iterator(), [](const auto& entry) {
        return entry.is_regular_file() && entry.path().filename() != "README.md";
    });
}

// The first group of each match outside fenced code, line by line.
std::vector<std::string> matches(const fs::path& text, const std::regex& pattern) {
    std::vector<std::string> found;
    std::istringstream lines(raylab::read_file(text));
    bool is_code = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) is_code = !is_code;
        if (is_code) continue;
        for (auto match = std::sregex_iterator(line.begin(), line.end(), pattern); match != std::sregex_iterator();
             ++match)
            found.push_back((*match)[1]);
    }
    return found;
}

// Whether a word in backticks names a file of the source tree: it ends as one, or it begins with one of the tree's
// folders.
bool names_a_file(const std::string& word) {
    static const std::regex ending(R"(.*\.(h|cpp|cmake|toml|json|md|sh))"), place(R"((\w+)/.*)");
    constexpr std::array folders{"lib", "chapters", "exercises", "tests", "cmake", "reference_images"};
    std::smatch match;
    return std::regex_match(word, ending) ||
           (std::regex_match(word, match, place) && std::ranges::find(folders, match[1].str()) != folders.end());
}

// What tells of the code itself: there, every word with a slash is a file or a folder.
bool is_about_the_code(const fs::path& text) {
    const fs::path place = fs::relative(text, root);
    return place == "CONTRIBUTING.md" || place == "exercises/README.md" ||
           (place.filename() == "README.md" && (*place.begin() == "lib" || place.parent_path() == "chapters/program" ||
                                                place.parent_path() == "exercises/grading"));
}

bool exists_from(const fs::path& text, const std::string& name) {
    const std::array bases{text.parent_path(), root, root / "lib/raylab"};
    return std::ranges::any_of(bases, [&](const fs::path& base) { return fs::exists(base / name); });
}

// Who uses an exercise's function: a file of the library, beside the one that declares it, of `raylab radiosity` or of
// what `raylab render` draws with.
enum class User { renderer, radiosity };

bool is_used_by(User user, const std::string& function) {
    const std::regex comment(R"(//[^\n]*)"), use("\\b" + function + R"(\b[()])");
    std::ptrdiff_t uses = 0;
    for (const auto& entry : entries(root / "lib/raylab")) {
        const fs::path place = fs::relative(entry.path(), root / "lib/raylab");
        if (entry.is_directory() || *place.begin() == "experiment" || place.parent_path().filename() == "slot")
            continue;
        if ((*place.begin() == "radiosity") != (user == User::radiosity)) continue;
        if (place.extension() != ".h" && place.extension() != ".cpp") continue;
        const std::string text = raylab::read_file(entry.path());
        if (text.find(function) == std::string::npos) continue;
        const std::string code = std::regex_replace(text, comment, "");
        uses += std::distance(std::sregex_iterator(code.begin(), code.end(), use), std::sregex_iterator());
    }
    return uses > 1;
}

}  // namespace

TEST_CASE("a layer has a README of at most 40 lines, and so has each larger folder") {
    std::vector<fs::path> folders;
    for (const auto* place : {"lib/raylab", "chapters/program", "exercises/grading"}) {
        if (files_in(root / place) > 8) folders.push_back(root / place);
        for (const auto& entry : entries(root / place))
            if (entry.is_directory() &&
                (entry.path().parent_path() == root / "lib/raylab" || files_in(entry.path()) > 8))
                folders.push_back(entry.path());
    }
    CHECK(folders.size() > 30);
    for (const auto& folder : folders) {
        INFO(folder);
        if (!fs::exists(folder / "README.md")) {
            FAIL_CHECK("expected a README.md, found none");
            continue;
        }
        CHECK(std::ranges::count(raylab::read_file(folder / "README.md"), '\n') <= 40);
    }
}

TEST_CASE("the map of the library names every layer") {
    const auto map = raylab::read_file(root / "lib/raylab/README.md");
    for (const auto& entry : fs::directory_iterator(root / "lib/raylab")) {
        if (!entry.is_directory()) continue;
        INFO(entry.path());
        CHECK(map.find("`" + entry.path().filename().string() + "/`") != std::string::npos);
    }
}

TEST_CASE("the front page links every chapter") {
    const auto page = raylab::read_file(root / "README.md");
    for (const auto& entry : fs::directory_iterator(root / "chapters")) {
        const std::string folder = entry.path().filename();
        if (folder == "program" || !entry.is_directory()) continue;
        INFO(folder);
        CHECK(page.find("(chapters/" + folder + "/README.md)") != std::string::npos);
    }
}

TEST_CASE("the table of exercises has each of them, and says truly which functions the lab draws with") {
    const auto table = raylab::read_file(root / "exercises/README.md");
    for (const auto& entry : fs::directory_iterator(root / "exercises")) {
        const std::string folder = entry.path().filename();
        if (!fs::exists(entry.path() / "judge.cpp")) continue;
        INFO(folder);
        static const std::string link = R"(\| \[\w+\]\()", function = R"(/README\.md\) \| `(\w+)` \| [^|]* \| (\w+))";
        std::smatch row;
        REQUIRE(std::regex_search(table, row, std::regex(link + folder + function)));
        CHECK((row[2] == "renderer") == is_used_by(User::renderer, row[1]));
        CHECK((row[2] == "radiosity") == is_used_by(User::radiosity, row[1]));
    }
}

TEST_CASE("a file that a text names in backticks exists") {
    // A word that is a link's text stands for the link, which is looked at below.
    static const std::regex pattern(R"(\[`[^`]*`|`([^`]*)`)"), one_word(R"([\w.\-/]+)");
    std::size_t checked = 0;
    for (const auto& text : texts())
        for (const auto& word : matches(text, pattern)) {
            if (!std::regex_match(word, one_word)) continue;
            if (!names_a_file(word) && !(is_about_the_code(text) && word.find('/') != std::string::npos)) continue;
            INFO(text << " names " << word);
            if (!exists_from(text, word)) FAIL_CHECK("expected this file, found none");
            ++checked;
        }
    CHECK(checked > 250);
}

TEST_CASE("a link in a text leads to a file") {
    // Code in a line may hold `[&](auto x)`, which is no link.
    static const std::regex pattern(R"(`[^`]*`|\]\(([^)\s#]+)[^)]*\))");
    std::size_t checked = 0;
    for (const auto& text : texts())
        for (const auto& link : matches(text, pattern)) {
            if (link.empty() || link.find("://") != std::string::npos) continue;
            INFO(text << " links to " << link);
            if (!fs::exists(text.parent_path() / link)) FAIL_CHECK("expected this file, found none");
            ++checked;
        }
    CHECK(checked > 100);
}
