#include "hostile/refusals.h"

#include "catch.h"

#include "raylab/base/error.h"

#include <algorithm>
#include <fstream>

namespace fs = std::filesystem;

namespace {

// The message of the Error; Catch reports any other exception.
std::string message(const fs::path& file, const std::function<void(const fs::path&)>& read) {
    try {
        read(file);
    } catch (const raylab::Error& error) {
        return error.what();
    }
    return "nothing: it was accepted";
}

}  // namespace

std::vector<Refusal> refusals(const fs::path& folder) {
    std::vector<Refusal> result;
    std::ifstream table(folder / "expected.txt");
    for (std::string line; std::getline(table, line);) {
        const auto bar = line.find(" | ");
        if (line.empty() || line.front() == '#') continue;
        REQUIRE(bar != line.npos);
        result.push_back({folder / line.substr(0, bar), line.substr(bar + 3)});
    }
    return result;
}

void check_refusals(const fs::path& folder, const std::function<void(const fs::path&)>& read) {
    const auto table = refusals(folder);
    REQUIRE_FALSE(table.empty());
    for (const auto& refusal : table) {
        INFO(refusal.file);
        const auto said = message(refusal.file, read);
        CHECK_THAT(said, Catch::Matchers::Contains(refusal.fragment));
        CHECK(said.find('\n') == said.npos);
    }
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().filename() == "expected.txt" || entry.path().filename() == "parts") continue;
        INFO(entry.path());
        CHECK(std::ranges::find(table, entry.path(), &Refusal::file) != table.end());
    }
}
