#include "catch.h"

#include "raylab/base/file.h"

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// A name in a namespace `detail` belongs to the folder that declares it: files of other folders use what is declared
// outside of it.

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> sources() {
    std::vector<fs::path> found;
    for (const auto* folder : {"lib", "chapters", "exercises", "tests"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(RAYLAB_SOURCE) / folder))
            if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") found.push_back(entry.path());
    return found;
}

// The names that a text declares in a namespace `detail`. It goes by the house's form: namespaces open, close and
// declare at the line's start.
std::set<std::string> detail_names(const std::string& text) {
    static const std::regex opens(R"(^namespace ([\w:]*::)?detail \{$)"),
        closes(R"(^\}  // namespace ([\w:]*::)?detail$)");
    static const std::regex declares(R"(^[\w\[:].*?\b(\w+)(?: =|\(| \{|;))");
    std::set<std::string> names;
    std::istringstream lines(text);
    std::smatch match;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_match(line, opens))
            inside = true;
        else if (std::regex_match(line, closes))
            inside = false;
        else if (inside && std::regex_search(line, match, declares))
            names.insert(match[1]);
    }
    return names;
}

// What a text names by `detail::`, but for other projects' details, as CLI::detail.
std::set<std::string> detail_uses(const std::string& text) {
    static const std::regex pattern(R"((\w+::)?\bdetail::(\w+))");
    std::set<std::string> uses;
    for (std::sregex_iterator use(text.begin(), text.end(), pattern), end; use != end; ++use)
        if (!(*use)[1].matched || (*use)[1] == "raylab::") uses.insert((*use)[2]);
    return uses;
}

}  // namespace

TEST_CASE("the names of a namespace detail are read where they are declared and where they are used") {
    const std::string text = "namespace raylab::detail {\n"
                             "template <class T>\nstruct Shear {\n    int member(int);\n};\n"
                             "[[gnu::cold]] constexpr float beyond(double x);\n"
                             "std::optional<Hit<T>> hit_between(const Ray<T>& ray,\n    int more);\n"
                             "constexpr double roundings = 64;\n"
                             "}  // namespace raylab::detail\nint outside(int);\n";
    CHECK(detail_names(text) == std::set<std::string>{"Shear", "beyond", "hit_between", "roundings"});
    CHECK(detail_uses("f(detail::a(1)); using raylab::detail::b; CLI::detail::c(2);") ==
          std::set<std::string>{"a", "b"});
}

TEST_CASE("what stands in a namespace detail is used in its own folder only") {
    std::map<std::string, std::set<fs::path>> folders;
    for (const auto& file : sources())
        for (const auto& name : detail_names(raylab::read_file(file))) folders[name].insert(file.parent_path());
    CHECK_FALSE(folders.empty());
    for (const auto& file : sources()) {
        if (file == __FILE__) continue;
        for (const auto& name : detail_uses(raylab::read_file(file))) {
            INFO(file << " uses detail::" << name);
            CHECK(folders[name].contains(file.parent_path()));
        }
    }
}
