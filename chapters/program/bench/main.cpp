// What `raylab bench` runs.

#include "growth.h"
#include "options.h"
#include "results.h"

#include "raylab/base/error.h"
#include "raylab/base/print.h"
#include "raylab/base/program.h"
#include "raylab/base/progress.h"
#include "raylab/report/json_text.h"
#include "raylab/scene/demo_meshes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace {

using namespace raylab;
using namespace raylab::bench;

std::vector<std::string> parts(const std::string& option, const std::string& list) {
    std::vector<std::string> all;
    std::istringstream text(list);
    for (std::string part; std::getline(text, part, ',');) {
        if (std::ranges::find(all, part) != all.end())  // its rows could not be told apart
            throw Error(option + ": expected each but once, found \"" + part + "\" again");
        if (!part.empty()) all.push_back(part);
    }
    if (all.empty()) throw Error(option + ": expected a list with commas, found \"" + list + "\"");
    return all;
}

std::vector<std::string> suited_meshes(const Arguments& arguments) {
    const bool quick = arguments.has("--quick");
    if (arguments.has("--growth") && quick) return {"bumpy_3", "bumpy_4", "bumpy_5", "bumpy_6"};
    if (arguments.has("--growth")) return {"bumpy_4", "bumpy_5", "bumpy_6", "bumpy_7", "bumpy_8"};
    if (quick) return {demo_mesh("bunny") ? "bunny" : "knot_8"};
    return usual_meshes();
}

std::vector<std::string> usual_peers() {
    auto names = foreign_peers();
    for (const char* ours : {"aabb_tree", "auto"}) names.push_back(ours);
    return names;
}

std::vector<int> thread_counts(const std::string& list) {
    std::vector<int> counts;
    for (const std::string& part : parts("--threads", list)) {
        if (part.find_first_not_of("0123456789") != std::string::npos || part.size() > 3 || std::stoi(part) < 1)
            throw Error("--threads: expected numbers from 1 to 999 with commas, found \"" + list + "\"");
        counts.push_back(std::stoi(part));
    }
    return counts;
}

Seconds clock_named(const std::string& name) {
    if (name == "wall") return Seconds::wall;
    if (name == "processor") return Seconds::processor;
    throw Error("--clock: expected wall or processor, found \"" + name + "\"");
}

RaceOptions race_options(const Arguments& arguments) {
    const bool quick = arguments.has("--quick");
    const auto threads = thread_counts(arguments.text("--threads"));
    const auto clock = clock_named(arguments.text("--clock"));
    if (clock == Seconds::processor && std::ranges::max(threads) > 1)
        throw Error("--clock processor: expected one thread, for it adds up the seconds of all; found --threads " +
                    arguments.text("--threads"));
    const auto list = [&](const char* option, std::vector<std::string> otherwise) {
        const auto text = arguments.text_if_given(option);
        return text ? parts(option, *text) : otherwise;
    };
    const auto number = [&](const char* option, int highest, int otherwise) {
        return arguments.has(option) ? static_cast<int>(arguments.integer(option, 1, highest)) : otherwise;
    };
    return {.meshes = list("--meshes", suited_meshes(arguments)),
            .rays = list("--rays", usual_rays()),
            .peers = list("--peers", usual_peers()),
            .threads = threads,
            .repetitions = number("--repetitions", 1000, quick ? 3 : 5),
            .size = number("--size", 4096, quick ? 256 : 1024),
            .clock = clock};
}

ExitCode run(const std::vector<std::string>& words) {
    const auto arguments = parse(command_line(), words);
    const auto options = race_options(arguments);
    for (const std::string& mesh : options.meshes) refuse_unknown_mesh(mesh);  // before minutes are spent on another
    const auto json = arguments.text_if_given("--json");
    std::vector<Row> rows;
    Progress progress("racing", options.meshes.size());
    for (const std::string& mesh : options.meshes) {
        const auto of_mesh = race(mesh, options);
        progress.step();
        rows.insert(rows.end(), of_mesh.begin(), of_mesh.end());
        if (json != "-") print_text(mesh_table(of_mesh) + "\n");
        flush_standard_output();
    }
    if (json) write_json(json_text(to_json(rows)), *json);
    if (json != "-") print_text(summary_table(rows));
    if (arguments.has("--growth") && json != "-") print_text("\n" + growth_table(growth(rows)));
    if (const auto folder = arguments.text_if_given("--out")) write_growth_charts(growth(rows), *folder);
    for (const std::string& missing : missing_peers()) print_note("not here, and so left out: " + missing + "\n");
    return ExitCode::as_it_should_be;
}

}  // namespace

int main(int argc, char** argv) {
    return run_program([&] { return run(words(argc, argv)); });
}
