#include "commands.h"
#include "retired_names.h"

#include "raylab/base/command_line.h"
#include "raylab/base/common_options.h"
#include "raylab/base/file.h"
#include "raylab/base/outputs.h"
#include "raylab/base/printable.h"
#include "raylab/report/json_text.h"
#include "raylab/report/structure/structure_replay.h"
#include "raylab/report/table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace raylab {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

const CommandLine stability_accelerators_command_line{
    .program = "raylab stability accelerators",
    .about =
        "Compares every structure with the exact list, by hard rays through hard scenes: they must find the same "
        "primitive,\n"
        "the same t, and whether there is a hit at all. One ray in a hundred through a small scene is also compared "
        "with\n"
        "the exact oracle. Where answers differ, the case is made as small as possible and written to a file for "
        "--replay.\n"
        "Exit code 0: no answer differs; 1: some do.",
    .options = {
        {"--rays", "N", "the number of rays for every structure; 0: until a difference is found", "100000"},
        {"--structure", "NAME", "test only this one; may be repeated: " + accelerator_list(), "", Option::Repeat::all},
        {"--seed", "S", "the seed of all random numbers", "1"},
        threads_option(),
        {"--out", "DIR", "the folder for differences", "out/differences"},
        {"--replay", "FILE", "repeat only the case of such a file"},
        {"--json", "FILE", "the results as JSON; - is standard output"}}};

std::vector<StructureMethod> asked_structures(const Arguments& arguments) {
    if (arguments.has("--structure")) return structure_methods(arguments.all("--structure"));
    std::vector<StructureMethod> methods;
    for (const std::string& name : accelerator_names())
        if (name != "list" && name != "auto") methods.push_back(structure_method(name));
    return methods;
}

/// A report, and the files to which its differences were written.
struct Outcome {
    DifferenceReport report;
    std::vector<std::string> files;  // one for each difference
};

Outcome searched(const DifferenceSearch& search, const fs::path& folder, Outputs& outputs) {
    Outcome outcome{find_differences(search), {}};
    for (const auto& difference : outcome.report.differences) {
        const auto name = fmt::format("{}_{}_{}.json", difference.structure, difference.seed, difference.piece);
        write_file(outputs.staged(folder).path / name, to_json(difference));
        outcome.files.push_back((folder / name).string());
    }
    return outcome;
}

std::uint64_t wrong_of(const DifferenceReport& report, const std::string& structure) {
    const auto found = report.wrong.find(structure);
    return found == report.wrong.end() ? 0 : found->second;
}

std::string to_text(const Outcome& outcome, const DifferenceSearch& search) {
    const auto& [report, files] = outcome;
    const DifferenceCount& total = report.total;
    std::vector<std::vector<std::string>> rows{
        {"list, by the oracle", std::to_string(total.oracle_rays), std::to_string(wrong_of(report, "list"))}};
    for (const auto& method : search.structures)
        rows.push_back(
            {method.name + ", by the list", std::to_string(total.rays), std::to_string(wrong_of(report, method.name))});
    std::string text = fmt::format("{} rays through {} scenes, {} of them hits, {} asked together, "
                                   "too; seed {}\n",
                                   total.rays, total.scenes, total.hits, total.together_rays, search.seed) +
                       text_table({"structure", "rays", "wrong"}, rows);
    for (std::size_t i = 0; i < files.size(); ++i) {
        const auto& difference = report.differences[i];
        text += fmt::format("\n{} (scene: {}; ray: {})\n  expected {}\n  found    {}\n  raylab stability "
                            "accelerators --replay {}\n",
                            difference.structure, difference.scene_kind, difference.ray_kind,
                            difference.answers.expected, difference.answers.found, files[i]);
    }
    return text;
}

ordered_json to_json(const DifferenceCount& count) {
    return {{"scenes", count.scenes},
            {"rays", count.rays},
            {"hits", count.hits},
            {"together_rays", count.together_rays},
            {"oracle_rays", count.oracle_rays}};
}

ordered_json to_json(const Outcome& outcome, const DifferenceSearch& search) {
    const auto& [report, files] = outcome;
    ordered_json json{{"seed", search.seed}};
    json.update(to_json(report.total));
    json["oracle_wrong"] = wrong_of(report, "list");
    for (const auto& [kind, count] : report.by_kind) json["scene_kinds"][kind] = to_json(count);
    json["structures"] = ordered_json::array();
    for (const auto& method : search.structures)
        json["structures"].push_back(
            {{"name", method.name}, {"answers", report.total.rays}, {"wrong", wrong_of(report, method.name)}});
    json["differences"] = files;
    return json;
}

ExitCode replay(const Arguments& arguments) {
    Outputs outputs({.files = arguments.given({"--json"}), .inputs = arguments.given({"--replay"})});
    const auto difference = read_difference(arguments.text("--replay"));
    const std::string name = arguments.has("--structure") ? arguments.all("--structure").back() : difference.structure;
    refuse_retired_structures(name);
    const auto judge = name == "list" ? CaseJudge(judge_by_oracle) : judge_by_list(structure_method(name));
    const auto answers = judge(difference.smallest);
    const std::string verdict =
        answers
            ? fmt::format("{} still differs\n  expected {}\n  found    {}\n", name, answers->expected, answers->found)
            : name + " answers as expected: " + printable(difference.answers.expected) + "\n";
    const auto json = arguments.text_if_given("--json");
    if (json)
        write_json(json_text({{"structure", name},
                              {"differs", answers.has_value()},
                              {"expected", answers ? answers->expected : difference.answers.expected},
                              {"found", answers ? answers->found : difference.answers.expected}}),
                   outputs[*json]);
    if (json != "-") outputs.say(verdict);
    outputs.commit();
    return answers ? ExitCode::negative : ExitCode::as_it_should_be;
}

}  // namespace

ExitCode stability_accelerators(const std::vector<std::string>& words) {
    const auto arguments = parse(stability_accelerators_command_line, words);
    if (arguments.has("--replay")) return replay(arguments);
    constexpr auto largest = std::numeric_limits<long long>::max();
    constexpr std::uint64_t a_round = 100'000;
    const auto wanted = static_cast<std::uint64_t>(arguments.integer("--rays", 0, largest));
    DifferenceSearch search{.structures = asked_structures(arguments),
                            .scenes = adversarial::every_scene_kind(),
                            .rays = wanted > 0 ? wanted : a_round,
                            .seed = *seed_if_given(arguments),
                            .threads = threads_of(arguments),
                            .label = "asking"};
    const auto json = arguments.text_if_given("--json");
    const fs::path folder = arguments.text("--out");
    Outputs outputs({.files = arguments.given({"--json"}), .folders = {folder}});
    for (;; ++search.seed) {
        const Outcome outcome = searched(search, folder, outputs);
        if (json) write_json(json_text(to_json(outcome, search)), outputs[*json]);
        if (json != "-") outputs.say(to_text(outcome, search));
        outputs.commit();  // after each round, so that its results can be read while the next ones run
        if (!outcome.files.empty()) return ExitCode::negative;
        if (wanted > 0) return ExitCode::as_it_should_be;
    }
}

}  // namespace raylab
