#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"
#include "raylab/image/compare.h"
#include "raylab/image/difference_picture.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/scene/demo_meshes.h"
#include "rotating.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

// The pictures of a chapter's README (chapters/NN_name/pictures/*.png and *.svg) and those kept as references
// (reference_images/NN_name/*.exr, each with a .txt that tells how it was made) must be what the chapter's program
// draws today. So must each table of a README below a line "<!-- table: NAME -->": row by row as on the page. Those in
// pictures/real_meshes are compared where the scanned meshes have been fetched. A run draws every third chapter
// (rotating.h). To accept an intended change: RAYLAB_UPDATE_PICTURES=1 ctest -R pictures, which draws all; look at each
// picture, commit.

using namespace raylab;
namespace fs = std::filesystem;

namespace {

const fs::path source = RAYLAB_SOURCE, build = RAYLAB_BUILD;

std::vector<fs::path> files_in(const fs::path& folder, const std::string& extension) {
    std::vector<fs::path> files;
    if (!fs::is_directory(folder)) return files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == extension) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::vector<std::string> chapters() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(source / "chapters"))
        if (fs::exists(entry.path() / "main.cpp") && entry.path().filename() != "program")
            names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
}

// A new run of a chapter, and the folder that it has filled.
struct Told {
    std::string chapter;
    ProcessResult result = {};
    fs::path folder() const { return build / "tests" / "pictures_of_today" / chapter; }
};

void tell(Told& story) {
    fs::remove_all(story.folder());
    story.result = run_process(build / "chapters" / story.chapter / story.chapter,
                               {"--out", story.folder().parent_path().string(), "--only", "story"}, {.timeout = 250});
}

std::vector<std::string> chapters_of_this_run() {
    std::vector<std::string> now;
    const auto all = chapters();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (is_tested_now(i, 5) || std::getenv("RAYLAB_UPDATE_PICTURES")) now.push_back(all[i]);
    return now;
}

// Two chapters at a time: each has parts that take one core alone.
std::vector<Told> told(const std::vector<std::string>& chapters) {
    std::vector<Told> stories;
    for (const auto& chapter : chapters) stories.push_back({.chapter = chapter});
    std::atomic<std::size_t> next = 0;
    const auto tell_next = [&] {
        for (std::size_t i = next++; i < stories.size(); i = next++) tell(stories[i]);
    };
    std::jthread other(tell_next);
    tell_next();
    other.join();
    return stories;
}

void check_same(const fs::path& today, const fs::path& kept) {
    INFO(today.string() << " against " << kept.string());
    if (std::getenv("RAYLAB_UPDATE_PICTURES")) fs::copy_file(today, kept, fs::copy_options::overwrite_existing);
    REQUIRE(fs::exists(today));
    const Image now = read_image(today), then = read_image(kept);
    const Comparison comparison = compare(now, then);
    const auto found = objections(comparison);
    if (found.empty()) return;
    fs::path difference = today;
    difference.replace_filename(today.stem().string() + "_difference.png");
    write_image(difference_picture(now, then, comparison), difference);
    for (const auto& objection : found) FAIL_CHECK(objection << "; see " << difference.string());
}

// A drawing is compared as text.
void check_same_drawing(const fs::path& today, const fs::path& kept) {
    INFO(today.string() << " against " << kept.string());
    if (std::getenv("RAYLAB_UPDATE_PICTURES")) fs::copy_file(today, kept, fs::copy_options::overwrite_existing);
    REQUIRE(fs::exists(today));
    CHECK((read_file(today) == read_file(kept)));
}

std::vector<std::string> lines_of(const fs::path& file) {
    std::istringstream text(read_file(file));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
}

// The rows of a page's tables in Markdown: "| 16 | 0.030 |".
std::set<std::string> table_rows(const fs::path& page) {
    static const std::regex begin("<t[hd]( [^>]*)?>"), end("</t[hd]>"), other("<[^>]*>");
    std::set<std::string> rows;
    for (const auto& line : lines_of(page)) {
        if (line.find("<tr>") == line.npos) continue;
        const auto cells = std::regex_replace(std::regex_replace(line, begin, " "), end, " |");
        rows.insert("|" + std::regex_replace(cells, other, ""));
    }
    return rows;
}

// The rows of a README's marked tables, without the rules below their headers.
std::vector<std::string> marked_rows(const fs::path& readme) {
    std::vector<std::string> rows;
    bool marked = false;
    for (const auto& line : lines_of(readme)) {
        const bool row = line.starts_with("|");
        if (marked && row && !line.starts_with("|--")) rows.push_back(line);
        marked =
            line == "<!-- a table of the chapter's page -->" || line.starts_with("<!-- table: ") || (marked && row);
    }
    return rows;
}

void check_tables(const fs::path& readme, const fs::path& page) {
    const auto shown = marked_rows(readme);
    if (shown.empty()) return;
    const auto made = table_rows(page);
    for (const auto& row : shown) {
        INFO(readme.string() << ": " << row << " is no row of " << page.string());
        CHECK(made.contains(row));
    }
}

}  // namespace

TEST_CASE("every picture and marked table in a chapter's README and every reference image is what the chapter draws "
          "today") {
    for (const Told& story : told(chapters_of_this_run())) {
        INFO(story.chapter << ": " << to_string(story.result) << "\n" << story.result.errors);
        REQUIRE(story.result.succeeded());
        const fs::path kept_in = source / "chapters" / story.chapter, today = story.folder();
        auto shown = files_in(kept_in / "pictures", ".png");
        const auto of_meshes = files_in(kept_in / "pictures/real_meshes", ".png");
        if (demo_mesh("elephant"))
            shown.insert(shown.end(), of_meshes.begin(), of_meshes.end());
        else if (!of_meshes.empty())
            WARN(story.chapter << ": the pictures of real meshes are not compared, since they have not been fetched");
        check_tables(kept_in / "README.md", today / "index.html");
        for (const auto& kept : shown) check_same(today / kept.filename(), kept);
        for (const auto& kept : files_in(kept_in / "pictures", ".svg"))
            check_same_drawing(today / kept.filename(), kept);
        for (const auto& kept : files_in(source / "reference_images" / story.chapter, ".exr"))
            check_same(today / kept.filename(), kept);
    }
}

TEST_CASE("the cover is what the command beside it draws") {
    if (!is_tested_now(0, 6) && !std::getenv("RAYLAB_UPDATE_PICTURES")) return;
    static const std::regex command(R"(\./raylab (render [^\n]*) -o chapters/cover\.png)");
    const std::string told = read_file(source / "chapters/cover.txt");
    std::smatch match;
    REQUIRE(std::regex_search(told, match, command));
    std::istringstream line(match[1]);
    std::vector<std::string> words{std::istream_iterator<std::string>(line), {}};
    const fs::path today = build / "tests" / "cover.png";
    words.insert(words.end(), {"-o", today.string()});
    const auto result = run_process(build / "raylab", words, {.folder = source, .timeout = 250});
    INFO(to_string(result) << "\n" << result.errors);
    REQUIRE(result.succeeded());
    check_same(today, source / "chapters/cover.png");
}

TEST_CASE("every reference image tells how it was made") {
    for (const std::string& chapter : chapters())
        for (fs::path kept : files_in(source / "reference_images" / chapter, ".exr")) {
            INFO(kept.string());
            CHECK(fs::exists(kept.replace_extension(".txt")));
        }
}

TEST_CASE("every picture that a README names is there, and no other") {
    for (const std::string& chapter : chapters()) {
        const fs::path folder = source / "chapters" / chapter;
        if (!fs::exists(folder / "README.md")) continue;
        const std::string readme = read_file(folder / "README.md");
        for (const std::string extension : {".png", ".svg"})
            for (const auto& picture : files_in(folder / "pictures", extension)) {
                INFO(picture.string());
                CHECK(readme.find("pictures/" + picture.filename().string()) != std::string::npos);
            }
        for (std::size_t at = readme.find("](pictures/"); at != std::string::npos;
             at = readme.find("](pictures/", at + 1)) {
            const std::size_t start = at + 2, end = readme.find(')', start);
            INFO(readme.substr(start, end - start));
            CHECK(fs::exists(folder / readme.substr(start, end - start)));
        }
    }
}
