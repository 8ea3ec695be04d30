#include "tree_difference.h"

#include "raylab/base/print.h"
#include "raylab/report/json_text.h"
#include "raylab/report/ray_tree/ray_tree_difference_report.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace raylab {

ExitCode report_difference(const ComparedTrees& trees, const std::optional<std::string>& output,
                           const std::optional<std::string>& json) {
    const auto difference = first_difference(trees.got, trees.expected);
    if (output && std::filesystem::path(*output).extension() == ".json")
        write_json(json_text(to_json(difference)), *output);
    else if (output)
        write_diagram(difference_diagram({trees.got, trees.got_title}, {trees.expected, trees.expected_title},
                                         difference, trees.view),
                      *output);
    if (json) write_json(json_text(to_json(difference)), *json);
    if (json != "-") print_text((difference ? to_string(*difference) : "the same tree") + std::string("\n"));
    return difference ? ExitCode::negative : ExitCode::as_it_should_be;
}

}  // namespace raylab
