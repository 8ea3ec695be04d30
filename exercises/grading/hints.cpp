#include "hints.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"

#include <toml++/toml.h>

namespace raylab::grading {

namespace {

std::string text_in(const toml::table& table, const std::string& file, const std::string& group, const std::string& key) {
    const auto text = table[group][key].value<std::string>();
    if (!text) throw Error({file}, "a text '" + key + "' in [" + group + "]", "none");
    return *text;
}

toml::table parsed(const std::string& file) {
    try {
        return toml::parse(read_file(file), file);
    } catch (const toml::parse_error& problem) {
        throw Error({file, static_cast<int>(problem.source().begin.line)}, "TOML", std::string(problem.description()));
    }
}

}  // namespace

Hints read_hints(const Exercise& exercise) {
    const auto file = std::string(RAYLAB_SOURCE) + "/exercises/" + exercise.folder + "/hints.toml";
    const auto table = parsed(file);
    Hints hints{.solution = text_in(table, file, "solution", "file"), .look = text_in(table, file, "solution", "look")};
    for (const auto* level : {"idea", "where", "nearly"}) hints.levels.push_back(text_in(table, file, "levels", level));
    for (const auto& [key, value] : table) {
        const std::string name(key.str());
        if (name != "levels" && name != "solution") hints.mistakes[name] = text_in(table, file, name, "text");
    }
    return hints;
}

}  // namespace raylab::grading
