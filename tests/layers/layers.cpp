#include "catch.h"

#include "raylab/base/file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

// DESIGN: data flows down this list; includes only point up it.
constexpr std::array layers{"base",        "number", "geometry",  "sampling",  "image",      "scene",
                            "accelerator", "tracer", "radiosity", "transport", "experiment", "report"};

std::ptrdiff_t depth(const std::string& layer) { return std::ranges::find(layers, layer) - layers.begin(); }

std::vector<fs::path> sources(const fs::path& folder) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") found.push_back(entry.path());
    return found;
}

// The files that a file includes, quoted or in angle brackets.
std::vector<std::string> includes(const fs::path& file) {
    static const std::regex pattern(R"(^\s*#\s*include\s*["<]([^">]+)[">])");
    std::vector<std::string> found;
    std::istringstream lines(raylab::read_file(file));
    std::smatch match;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_search(line, match, pattern)) found.push_back(match[1]);
    return found;
}

const fs::path root = RAYLAB_SOURCE;

}  // namespace

TEST_CASE("every folder of the library is a layer") {
    for (const auto& entry : fs::directory_iterator(root / "lib/raylab")) {
        if (!entry.is_directory()) continue;  // the map
        INFO(entry.path());
        CHECK(depth(entry.path().filename()) < std::ssize(layers));
    }
}

TEST_CASE("includes point to the same layer or an earlier one") {
    const auto library = root / "lib/raylab";
    for (const auto& file : sources(library)) {
        const auto layer = fs::relative(file, library).begin()->string();
        for (const auto& include : includes(file)) {
            if (!include.starts_with("raylab/")) continue;
            INFO(file << " includes " << include);
            CHECK(depth(std::next(fs::path(include).begin())->string()) <= depth(layer));
        }
    }
}

// Whether a file may include heavy headers: *_cgal.h, which no plain header includes, and the bench's peer.
bool is_heavy_inside(const fs::path& file) {
    return file.filename().string().ends_with("_cgal.h") || file.filename() == "cgal_peer.cpp";
}

TEST_CASE("no plain header and no chapter sees CGAL, OpenImageIO or Graphviz") {
    const auto is_heavy = [](const std::string& include) {
        return include.starts_with("CGAL/") || include.starts_with("OpenImageIO/") ||
               include.starts_with("graphviz/") || include == "gvc.h" || include == "cgraph.h" ||
               include.ends_with("_cgal.h") || include.starts_with("CLI/") || include.starts_with("toml++/");
    };
    for (const auto* folder : {"lib", "chapters", "exercises"})
        for (const auto& file : sources(root / folder)) {
            if ((std::string(folder) == "lib" && file.extension() != ".h") || is_heavy_inside(file)) continue;
            for (const auto& include : includes(file)) {
                INFO(file << " includes " << include);
                CHECK_FALSE(is_heavy(include));
            }
        }
}

TEST_CASE("JSON is parsed in one place, which bounds how deep it nests") {
    static const std::regex parses(R"([Jj]son::(parse|accept|sax_parse)\b)");
    for (const auto* folder : {"lib", "chapters", "exercises"})
        for (const auto& file : sources(root / folder)) {
            if (file.filename() == "read_json.cpp") continue;
            INFO(file);
            CHECK_FALSE(std::regex_search(raylab::read_file(file), parses));
        }
}

TEST_CASE("a chapter's story fits 150 lines") {
    for (const auto& file : sources(root / "chapters")) {
        if (file.filename() != "main.cpp" || file.parent_path().filename() == "program") continue;
        const auto text = raylab::read_file(file);
        INFO(file);
        CHECK(std::ranges::count(text, '\n') <= 150);
    }
}

TEST_CASE("nothing in the library or the chapters knows an absolute path of one machine") {
    static const std::regex home(R"((/home/|/root/|/Users/))");
    for (const auto* folder : {"lib", "chapters", "exercises", "cmake"})
        for (const auto& file : sources(root / folder)) {
            INFO(file);
            CHECK_FALSE(std::regex_search(raylab::read_file(file), home));
        }
}
