// The program behind `raylab bench`.

#include "error_chart.h"
#include "growth.h"
#include "kinds.h"
#include "options.h"
#include "race_options.h"
#include "results.h"

#include "raylab/base/outputs.h"
#include "raylab/base/print.h"
#include "raylab/base/program.h"
#include "raylab/base/progress.h"
#include "raylab/report/chart/chart.h"
#include "raylab/report/json_text.h"

#include <nlohmann/json.hpp>

namespace {

using namespace raylab;
using namespace raylab::bench;

std::vector<std::string> usual_peers() {
    auto names = foreign_peers();
    for (const char* ours : {"bvh", "auto"}) names.push_back(ours);
    return names;
}

void write_charts(const std::vector<Row>& rows, const std::filesystem::path& folder) {
    write_growth_charts(growth(rows), folder);
    if (const Experiment errors = error_against_speed(rows); !errors.rows.empty())
        write_chart(errors, folder, "error_against_speed");
}

ExitCode run(const std::vector<std::string>& words) {
    const auto arguments = parse(command_line(), words);
    const auto options = race_options(arguments, usual_peers());
    // Refuses an unknown peer before minutes are spent on another.
    for (const std::string& peer : options.peers) peer_kind(peer);
    const auto json = arguments.text_if_given("--json"), folder = arguments.text_if_given("--out");
    Outputs outputs({.files = arguments.given({"--json"}),
                     .folders = arguments.given({"--out"}),
                     .inputs = {options.meshes.begin(), options.meshes.end()}});
    std::vector<Row> rows;
    Progress progress("racing", options.meshes.size());
    for (const std::string& mesh : options.meshes) {
        const auto of_mesh = race(mesh, options);
        progress.step();
        rows.insert(rows.end(), of_mesh.begin(), of_mesh.end());
        if (json != "-") print_text(mesh_table(of_mesh) + "\n");
        flush_standard_output();
    }
    if (json) write_json(json_text(to_json(rows)), outputs[*json]);
    if (json != "-") outputs.say(summary_table(rows) + "\n" + kinds_table(rows) + goals_table(rows));
    if (arguments.has("--growth") && json != "-") outputs.say("\n" + growth_table(growth(rows)));
    if (folder) outputs.naming_folders([&] { write_charts(rows, outputs.staged(*folder).path); });
    outputs.commit();
    for (const std::string& missing : missing_peers()) print_note("not here, and so left out: " + missing + "\n");
    return ExitCode::as_it_should_be;
}

}  // namespace

int main(int argc, char** argv) {
    return run_program([&] { return run(words(argc, argv)); });
}
