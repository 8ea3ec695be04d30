#include "package.h"

#include "handout.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/nearest_name.h"
#include "raylab/base/with_all_replaced.h"
#include "raylab/report/provenance.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

void copy_script(const Exercise& exercise, const fs::path& from, const fs::path& to) {
    auto text = with_all_replaced(read_file(from), "@NN@", exercise.folder.substr(0, exercise.folder.find('_')));
    text = with_all_replaced(text, "@SLOT@", exercise.slot);
    text = with_all_replaced(text, "@FOLDER@", exercise.folder);
    write_file(to, text);
    fs::permissions(to, fs::status(from).permissions());
}

}  // namespace

std::vector<std::string> package_kinds() {
    std::vector<std::string> kinds;
    for (const auto& entry : fs::directory_iterator(source_folder() / "exercises/package"))
        kinds.push_back(entry.path().filename().string());
    std::ranges::sort(kinds);
    return kinds;
}

void write_package(const Exercise& exercise, const std::string& kind, const fs::path& folder) {
    const auto kinds = package_kinds();
    if (std::ranges::find(kinds, kind) == kinds.end())
        throw Error(fmt::format("expected --for {}, found {}", fmt::join(kinds, ", "), with_suggestion(kind, kinds)));
    const auto scripts = source_folder() / "exercises/package" / kind;
    for (const auto& entry : fs::recursive_directory_iterator(scripts))
        if (entry.is_regular_file())
            copy_script(exercise, entry.path(), folder / entry.path().lexically_relative(scripts));
    write_handout(folder / "lab");
}

}  // namespace raylab::grading
