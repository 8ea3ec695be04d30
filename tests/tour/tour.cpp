#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

// Tests of the lab from outside: the tour end to end, the lab book's links, and the commands that the coverage table
// promises.

namespace fs = std::filesystem;
using namespace raylab;

namespace {

const fs::path source = RAYLAB_SOURCE;
const fs::path out = fs::path(RAYLAB_BUILD) / "tests/tour";

ProcessResult lab(const std::vector<std::string>& words) {
    return run_process(fs::path(RAYLAB_BUILD) / "raylab", words, {.folder = source, .timeout = 600});
}

// The files to which a page refers by src and href, without other sites and places on the page itself.
std::vector<std::string> references(const fs::path& page) {
    static const std::regex pattern(R"re((?:src|href)="([^"#]+)(?:#[^"]*)?")re");
    const auto html = read_file(page);
    std::vector<std::string> found;
    for (auto match = std::sregex_iterator(html.begin(), html.end(), pattern); match != std::sregex_iterator(); ++match)
        if ((*match)[1].str().find("://") == std::string::npos && !(*match)[1].str().starts_with("data:"))
            found.push_back((*match)[1]);
    return found;
}

std::size_t broken_links(const fs::path& folder) {
    std::size_t broken = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".html") continue;
        for (const auto& reference : references(entry.path())) {
            if (fs::exists(entry.path().parent_path() / reference)) continue;
            UNSCOPED_INFO(entry.path() << " refers to " << reference << ", which is not there");
            ++broken;
        }
    }
    return broken;
}

// The commands of the coverage table, each once and without its first word: "./raylab chart ray_sphere --quick".
std::set<std::string> promised_commands() {
    static const std::regex pattern(R"(\| `\./raylab ([^`]+)` \|)");
    const auto table = read_file(source / "chapters/README.md");
    std::set<std::string> found;
    for (auto match = std::sregex_iterator(table.begin(), table.end(), pattern); match != std::sregex_iterator();
         ++match)
        found.insert((*match)[1]);
    return found;
}

// Whether the tour has done the command's work: told the chapter's story, made the figure, or drawn the chart, in the
// folder of the chapter that `raylab chart` names.
bool is_in_the_book(const std::string& command) {
    static const std::regex story(R"(chapter (\d\d) --quick (--only story|--figure (\w+)))"),
        chart(R"(chart (\w+) --quick)");
    static const std::string questions = lab({"chart"}).output;
    std::smatch match;
    if (std::regex_match(command, match, story))
        return std::ranges::any_of(fs::directory_iterator(out / "book"), [&](const fs::directory_entry& entry) {
            if (!entry.path().filename().string().starts_with(match[1].str() + "_")) return false;
            if (!match[3].matched) return fs::exists(entry.path() / "index.html");
            return fs::exists(entry.path() / (match[3].str() + ".svg")) ||
                   fs::exists(entry.path() / (match[3].str() + ".png"));
        });
    if (!std::regex_match(command, match, chart)) return false;
    const std::regex line("(?:^|\n)" + match[1].str() + R"(  \(chapter (\w+)\)\n)");
    std::smatch asked;
    return std::regex_search(questions, asked, line) &&
           fs::exists(out / "book" / asked[1].str() / (match[1].str() + ".json"));
}

std::vector<std::string> split(const std::string& line) {
    std::istringstream stream(line);
    return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace

TEST_CASE("the tour runs every chapter and writes a lab book whose links all lead somewhere") {
    fs::remove_all(out);
    const auto result = lab({"tour", "--quick", "--out", (out / "book").string()});
    INFO(result.output << result.errors);
    REQUIRE(result.code == 0);
    REQUIRE(fs::exists(out / "book/index.html"));
    std::smatch first;
    REQUIRE(std::regex_search(result.output, first, std::regex("^ 1 of (\\d+)  01 ")));
    CHECK_THAT(result.output, Catch::Contains("\n" + first[1].str() + " of " + first[1].str() + "  "));
    CHECK(references(out / "book/index.html").size() >= 8);
    CHECK(broken_links(out / "book") == 0);
}

TEST_CASE("the lab book tells of each exercise which mistakes are caught, and by which hint: all, by the one meant") {
    const auto page = read_file(out / "book/mistakes.html");
    CHECK(page.find("✗") == std::string::npos);
    for (const auto& entry : fs::directory_iterator(source / "exercises")) {
        if (!fs::exists(entry.path() / "mistakes")) continue;
        INFO(entry.path());
        const auto folder = entry.path().filename().string();
        const auto begin = page.find("<section id=\"" + folder + "\"");
        REQUIRE(begin != std::string::npos);
        const auto section = page.substr(begin, page.find("</section>", begin) - begin);
        for (const auto& mistake : fs::directory_iterator(entry.path() / "mistakes")) {
            auto name = mistake.path().stem().string();
            std::ranges::replace(name, '_', ' ');
            CHECK(section.find(name) != std::string::npos);
        }
    }
}

TEST_CASE("the lab book is light: a page has at most 2 MB with all that is inside, a chapter's folder 12") {
    constexpr std::uintmax_t megabyte = 1'000'000;
    for (const auto& chapter : fs::directory_iterator(out / "book")) {
        if (!chapter.is_directory()) continue;
        std::uintmax_t bytes = 0;
        for (const auto& file : fs::recursive_directory_iterator(chapter)) {
            if (file.is_regular_file()) bytes += file.file_size();
            INFO(file.path());
            CHECK((file.path().extension() != ".html" || file.file_size() < 2 * megabyte));
            CHECK(file.path().extension() != ".exr");  // the lightbox tells the values
        }
        INFO(chapter.path());
        CHECK(bytes < 12 * megabyte);
    }
}

TEST_CASE("every command that the coverage table promises runs") {
    const auto commands = promised_commands();
    CHECK(commands.size() >= 8);
    std::set<std::string>
        kinds;  // of commands whose work the tour has done: the first of each is run by its own words, too
    for (const auto& command : commands) {
        auto words = split(command);
        if (is_in_the_book(command) && !kinds.insert(words.front()).second) continue;
        if (words.front() == "chart") words.insert(words.end(), {"-o", (out / "promised").string()});
        if (words.front() == "chapter") words.insert(words.end(), {"--out", (out / "promised").string()});
        const auto result = lab(words);
        INFO("./raylab " << command << "\n" << result.errors);
        CHECK(result.code == 0);
    }
}

TEST_CASE("stability finds a case by its name, and an unknown one is refused with exit 2") {
    const auto known = lab({"stability", "MIRROR", "--json", "-"});
    CHECK(known.code == 0);
    CHECK(nlohmann::json::accept(known.output));
    const auto unknown = lab({"stability", "NO-SUCH-CASE"});
    CHECK(unknown.code == 2);
    CHECK(std::ranges::count(unknown.errors, '\n') == 1);
}
