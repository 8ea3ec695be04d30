#include "catch.h"

#include "raylab/base/file.h"

#include <filesystem>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

// Two types with one name in one namespace violate C++'s one-definition rule, even if no file includes both: their
// inline functions have the same name, and the linker keeps one of them.

namespace fs = std::filesystem;

namespace {

const fs::path library = fs::path(RAYLAB_SOURCE) / "lib/raylab";

// The types that a file defines in a namespace that other files share, with their namespaces. It relies on the house's
// form: namespaces and such types begin at the start of a line.
std::vector<std::string> shared_types(const fs::path& file) {
    static const std::regex opens(R"(^namespace ?([\w:]*) ?\{$)"), closes(R"(^\}  // namespace.*)");
    static const std::regex defines(
        R"(^(?:struct|class|enum class) (?:alignas\(\w+\) )?(\w+)(?: final)?(?: : .*| \{.*)$)");
    std::vector<std::string> namespaces, found;
    std::istringstream lines(raylab::read_file(file));
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_match(line, match, opens)) {
            namespaces.push_back(match[1]);
        } else if (std::regex_match(line, closes) && !namespaces.empty()) {
            namespaces.pop_back();
        } else if (std::regex_match(line, match, defines)) {
            std::string name;
            bool is_shared = true;
            for (const std::string& space : namespaces) {
                name += space + "::";
                is_shared = is_shared && !space.empty();
            }
            if (is_shared) found.push_back(name + match[1].str());
        }
    }
    return found;
}

}  // namespace

TEST_CASE("no two types of the library have one name in one namespace") {
    std::map<std::string, fs::path> defined;
    for (const auto& entry : fs::recursive_directory_iterator(library)) {
        const fs::path& file = entry.path();
        if (file.extension() != ".h" && file.extension() != ".cpp") continue;
        for (const std::string& type : shared_types(file)) {
            const auto [known, is_new] = defined.emplace(type, file);
            INFO(type << " in " << file << " and " << known->second);
            CHECK((is_new || known->second == file));
        }
    }
    CHECK(defined.size() > 300);
}
