#include "hints.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/report/provenance.h"
#include "raylab/scene/toml/value.h"

namespace raylab::grading {

namespace {

using toml_file::Value;

std::string text_in(const Value& hints, const std::string& file, const std::string& group, const std::string& key) {
    const auto* found = toml_file::find(std::get<Value::Table>(hints.data), group);
    const auto* table = found ? std::get_if<Value::Table>(&found->value.data) : nullptr;
    const auto* entry = table ? toml_file::find(*table, key) : nullptr;
    const auto* text = entry ? std::get_if<std::string>(&entry->value.data) : nullptr;
    if (!text)
        throw Error({file}, "a text '" + key + "' in [" + group + "]",
                    entry ? toml_file::in_words(entry->value) : "none");
    return *text;
}

}  // namespace

std::map<std::string, std::string> read_general_hints() {
    const auto file = (source_folder() / "exercises/hints.toml").string();
    const auto root = toml_file::parse(read_file(file), file);
    std::map<std::string, std::string> hints;
    for (const auto& entry : std::get<Value::Table>(root.data))
        hints[entry.name] = text_in(root, file, entry.name, "text");
    return hints;
}

Hints read_hints(const Exercise& exercise) {
    const auto file = (source_folder() / "exercises" / exercise.folder / "hints.toml").string();
    const auto root = toml_file::parse(read_file(file), file);
    Hints hints{.solution = text_in(root, file, "solution", "file"), .look = text_in(root, file, "solution", "look")};
    for (const auto* level : {"idea", "where", "nearly"}) hints.levels.push_back(text_in(root, file, "levels", level));
    for (const auto& [name, value, line, column] : std::get<Value::Table>(root.data))
        if (name != "levels" && name != "solution") hints.mistakes[name] = text_in(root, file, name, "text");
    hints.general = read_general_hints();
    return hints;
}

const std::string* Hints::text(const std::string& id) const {
    for (const auto* known : {&mistakes, &general})
        if (const auto found = known->find(id); found != known->end()) return &found->second;
    return nullptr;
}

}  // namespace raylab::grading
