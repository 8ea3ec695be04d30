#include "hints.h"

#include "raylab/base/file.h"
#include "raylab/report/provenance.h"
#include "raylab/scene/toml/toml_table.h"

namespace raylab::grading {

std::map<std::string, std::string> read_general_hints() {
    const auto file = (source_folder() / "exercises/hints.toml").string();
    const auto root = toml_file::parse(read_file(file), file);
    const TomlTable table(root, file);
    std::map<std::string, std::string> hints;
    for (const auto& id : table.keys()) hints[id] = table.table(id).text("text");
    return hints;
}

Hints read_hints(const Exercise& exercise) {
    const auto file = (source_folder() / "exercises" / exercise.folder / "hints.toml").string();
    const auto root = toml_file::parse(read_file(file), file);
    const TomlTable table(root, file);
    const auto solution = table.table("solution");
    Hints hints{.look = solution.text("look")};
    if (const auto* path = solution.find<std::string>("file", "a text")) hints.solution = *path;
    for (const auto* level : {"idea", "where", "nearly"}) hints.levels.push_back(table.table("levels").text(level));
    for (const auto& id : table.keys())
        if (id != "levels" && id != "solution") hints.mistakes[id] = table.table(id).text("text");
    hints.general = read_general_hints();
    return hints;
}

const std::string* Hints::text(const std::string& id) const& {
    for (const auto* known : {&mistakes, &general})
        if (const auto found = known->find(id); found != known->end()) return &found->second;
    return nullptr;
}

}  // namespace raylab::grading
