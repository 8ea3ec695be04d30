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

/// In the order of their names, so that each has its turn.
std::vector<fs::path> chapters_with_a_lesson() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(source / "chapters"))
        if (fs::exists(entry.path() / "main.cpp") && fs::exists(entry.path() / "README.md"))
            found.push_back(entry.path());
    std::ranges::sort(found);
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
    const auto all = chapters_with_a_lesson();
    std::size_t found = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto commands = commands_in(try_this(read_file(all[i] / "README.md")));
        found += commands.size();
        // A lesson's commands go together: `compare` reads what `render` wrote.
        if (!is_tested_now(i, 4)) continue;
        const fs::path folder = fs::path(RAYLAB_BUILD) / "tests/tried" / all[i].filename();
        fs::remove_all(folder);
        fs::create_directories(folder);
        if (fs::exists(all[i] / "scene.toml")) fs::copy_file(all[i] / "scene.toml", folder / "mine.toml");
        for (const Words& words : commands) {
            const auto result =
                run_process(fs::path(RAYLAB_BUILD) / "raylab", made_small(words), {.folder = folder, .timeout = 120});
            INFO(all[i].filename() << ": " << words[0] << ' ' << words[1] << ": " << to_string(result) << '\n'
                                   << result.errors);
            CHECK(result.code == 0);
        }
    }
    CHECK(found >= 20);
}
