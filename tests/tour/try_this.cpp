#include "catch.h"
#include "rotating.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

// The commands in the lessons' parts "Try this", run as small and quick as they can be, in a folder in which mine.toml
// is a copy of the chapter's scene.

namespace fs = std::filesystem;
using namespace raylab;

namespace {

const fs::path source = RAYLAB_SOURCE;

using Words = std::vector<std::string>;

std::string try_this(const std::string& lesson) {
    const auto begin = lesson.find("\n## Try this\n");
    if (begin == lesson.npos) return "";
    return lesson.substr(begin, lesson.find("\n## ", begin + 1) - begin);
}

// `./raylab render x.toml -o x.png` without its first word; a command's name alone is a mention.
std::vector<Words> commands_in(const std::string& text) {
    static const std::regex command(R"(`\./raylab ([^`]+)`)"), word(R"(\S+)");
    std::vector<Words> found;
    for (auto each = std::sregex_iterator(text.begin(), text.end(), command); each != std::sregex_iterator(); ++each) {
        const std::string line = (*each)[1];
        Words words;
        for (auto one = std::sregex_iterator(line.begin(), line.end(), word); one != std::sregex_iterator(); ++one)
            words.push_back(one->str());
        if (words.size() > 1) found.push_back(words);
    }
    return found;
}

Words made_small(Words words) {
    for (auto& word : words)
        if (word.starts_with("chapters/")) word = (source / word).string();
    const auto has = [&](const std::string& option) { return std::ranges::find(words, option) != words.end(); };
    const bool draws = words.front() == "render" || words.front() == "radiosity";
    if (draws && !has("--size")) words.insert(words.end(), {"--size", "32x24"});
    if (words.front() == "chapter" && !has("--figure")) words.insert(words.end(), {"--only", "story"});
    if (words.front() == "chapter" || words.front() == "chart" || words.front() == "stability")
        words.push_back("--quick");
    return words;
}

}  // namespace

TEST_CASE("every command of the lessons' experiments runs") {
    std::size_t found = 0;
    for (const auto& chapter : fs::directory_iterator(source / "chapters")) {
        if (!fs::exists(chapter.path() / "main.cpp") || !fs::exists(chapter.path() / "README.md")) continue;
        const fs::path folder = fs::path(RAYLAB_BUILD) / "tests/tried" / chapter.path().filename();
        fs::remove_all(folder);
        fs::create_directories(folder);
        if (fs::exists(chapter.path() / "scene.toml"))
            fs::copy_file(chapter.path() / "scene.toml", folder / "mine.toml");
        for (const Words& words : commands_in(try_this(read_file(chapter.path() / "README.md")))) {
            if (!is_tested_now(found++, 4)) continue;
            const auto result =
                run_process(fs::path(RAYLAB_BUILD) / "raylab", made_small(words), {.folder = folder, .timeout = 120});
            INFO(chapter.path().filename() << ": " << words[0] << ' ' << words[1] << ": " << to_string(result) << '\n'
                                           << result.errors);
            CHECK(result.code == 0);
        }
    }
    CHECK(found >= 20);
}
