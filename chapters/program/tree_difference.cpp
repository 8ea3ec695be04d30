#include "tree_difference.h"

#include "raylab/base/print.h"
#include "raylab/report/json_text.h"
#include "raylab/report/ray_tree/ray_tree_difference_report.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace raylab {

ExitCode report_difference(const ComparedTrees& trees, const std::optional<std::string>& output,
                           const std::optional<std::string>& json, Outputs& outputs) {
    const auto difference = first_difference(trees.got, trees.expected);
    if (output && std::filesystem::path(*output).extension() == ".json")
        write_json(json_text(to_json(difference)), outputs[*output]);
    else if (output)
        write_diagram(difference_diagram({trees.got, trees.got_title}, {trees.expected, trees.expected_title},
                                         difference, trees.view),
                      outputs[*output]);
    if (json) write_json(json_text(to_json(difference)), outputs[*json]);
    if (json != "-") outputs.say((difference ? to_string(*difference) : "the same tree") + std::string("\n"));
    outputs.commit();
    return difference ? ExitCode::negative : ExitCode::as_it_should_be;
}

}  // namespace raylab
