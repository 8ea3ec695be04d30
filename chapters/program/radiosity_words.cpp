#include "radiosity_words.h"

#include "raylab/radiosity/solve/solution_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace raylab {

namespace {

nlohmann::ordered_json to_json(const RowSums& sums) {
    return {{"least", sums.least}, {"largest", sums.largest}, {"mean", sums.mean}};
}

std::vector<std::string> rebuilt(const RadiosityCache* cache) {
    return cache ? cache->sentences() : std::vector<std::string>{};
}

std::string rebuilt_words(const RadiosityCache& cache) {
    std::string text = "\n";
    for (const std::string& sentence : cache.sentences()) text += sentence + "\n";
    return text;
}

}  // namespace

nlohmann::ordered_json radiosity_json(const SceneRadiosity& solved, const SceneRadiosityOptions& options) {
    auto json = solution_json(solved.system, solved.solution, options.solving);
    json["patches"] = solved.mesh->patches.size();
    json["vertices"] = solved.mesh->vertices.size();
    json["surface_error"] = solved.mesh->model.error;
    json["links"] = solved.work.links;
    json["shadow_rays"] = solved.work.rays;
    json["rows_before_scaling"] = to_json(solved.rows_before);
    json["bytes"] = solved.bytes;
    json["seconds"] = {{"mesh", solved.seconds.mesh},
                       {"form_factors", solved.seconds.form_factors},
                       {"light", solved.seconds.light},
                       {"solve", solved.seconds.solve}};
    json["reused"] = {{"form_factors", solved.reused.form_factors}, {"solution", solved.reused.solution}};
    json["rebuilt"] = rebuilt(options.cache);
    return json;
}

std::string cache_words(const SceneRadiosity& solved, const RadiosityCache* cache) {
    if (!cache) return "";
    const auto& [form_factors, solution] = solved.reused;
    std::string text = "reused: ";
    text += form_factors ? (solution ? "form factors and solution" : "form factors")
                         : (solution ? "the solution" : "nothing; form factors and solution are kept");
    return text + rebuilt_words(*cache);
}

std::string cache_words(const SceneHierarchy& solved, const RadiosityCache* cache) {
    if (!cache) return "";
    const auto& [links, of, solution] = solved.reused;
    const std::string text = solution    ? "links and solution"
                             : links > 0 ? fmt::format("{} of {} links that were asked for", links, of)
                                         : "nothing; links and solution are kept";
    return "reused: " + text + rebuilt_words(*cache);
}

nlohmann::ordered_json with_error(nlohmann::ordered_json json, const PictureError& error) {
    json["picture_error"] = {{"relative", error.relative}, {"points", error.points}, {"seconds", error.seconds}};
    return json;
}

std::string error_words(const PictureError& error) {
    return fmt::format("error of the picture, estimated at {} points: {:.2g} of the mean (root mean square)\n",
                       error.points, error.relative);
}

nlohmann::ordered_json attempts_json(const RadiosityWithin& within) {
    auto attempts = nlohmann::ordered_json::array();
    for (const auto& [mesh, patches, error, seconds] : within.attempts)
        attempts.push_back({{"mesh", mesh}, {"patches", patches}, {"error", error}, {"seconds", seconds}});
    return attempts;
}

std::string attempts_words(const RadiosityWithin& within) {
    std::string text;
    for (const auto& [mesh, patches, error, seconds] : within.attempts)
        text += fmt::format("{} {} {}: error {:.2g}, {:.2g} s\n", text.empty() ? "tried" : "then", patches,
                            mesh == "hierarchical" ? "hierarchical patches" : mesh, error, seconds);
    return text;
}

std::string radiosity_words(const SceneRadiosity& solved) {
    const auto& [mesh, form_factors, light, solve] = solved.seconds;
    std::string text = fmt::format("{} patches, {} form factors that are not 0, {} shadow rays\n",
                                   solved.mesh->patches.size(), solved.work.links, solved.work.rays);
    if (solved.mesh->model.error > 0)
        text += fmt::format("curved surfaces: at most {:.2g} m from their patches\n", solved.mesh->model.error);
    text += fmt::format("row sums from {:.6f} to {:.6f}, in the mean {:.6f}", solved.rows_before.least,
                        solved.rows_before.largest, solved.rows_before.mean);
    text += fmt::format(" (scaled: to {:.6f})\n", solved.rows_after.largest);
    text += fmt::format("{}: {} iterations, residual {:.2g}, error of a radiosity at most {:.2g} of the largest\n",
                        solved.solution.solver, solved.solution.iterations, solved.solution.residual,
                        solved.solution.error_bound);
    return text + fmt::format("{:.3g} s: mesh {:.2g}, form factors {:.3g}, light {:.2g}, solving {:.2g}\n",
                              mesh + form_factors + light + solve, mesh, form_factors, light, solve);
}

nlohmann::ordered_json radiosity_json(const SceneHierarchy& solved, const RadiosityCache* cache) {
    const HierarchyWork& work = solved.solution.work;
    return {{"solver", "hierarchical"},
            {"iterations", work.iterations},
            {"rounds", work.rounds},
            {"residual", work.residual},
            {"power", power_json(solved.power)},
            {"patches", solved.mesh->patches.size()},
            {"vertices", solved.mesh->vertices.size()},
            {"elements", solved.solution.elements.size()},
            {"surface_error", solved.mesh->model.error},
            {"links", work.links},
            {"bytes", work.bytes},
            {"link_error", work.allowed},
            {"sum_of_link_errors", {{"largest", work.largest_error}, {"mean", work.mean_error}}},
            {"shadow_rays", work.rays},
            {"seconds", {{"solve", solved.seconds.solve}, {"mesh", solved.seconds.mesh}}},
            {"reused", {{"links", solved.reused.links}, {"solution", solved.reused.solution}}},
            {"rebuilt", rebuilt(cache)}};
}

std::string radiosity_words(const SceneHierarchy& solved) {
    const HierarchyWork& work = solved.solution.work;
    const auto patches = static_cast<double>(solved.mesh->patches.size());
    std::string text =
        fmt::format("{} patches, {} links of {} elements, where all pairs of patches are {:.2g}\n",
                    solved.mesh->patches.size(), work.links, solved.solution.elements.size(), patches * patches);
    if (solved.mesh->model.error > 0)
        text += fmt::format("curved surfaces: at most {:.2g} m from their patches\n", solved.mesh->model.error);
    text += fmt::format("error of a link at most {:.2g}; of a patch in the mean {:.2g}, were all of one sign\n",
                        work.allowed, work.mean_error);
    return text + fmt::format("{} rounds, {} iterations, {:.3g} s: solving {:.3g}, mesh {:.2g}\n", work.rounds,
                              work.iterations, solved.seconds.solve + solved.seconds.mesh, solved.seconds.solve,
                              solved.seconds.mesh);
}

}  // namespace raylab
