#include "exchanges.h"

#include "raylab/scene/mean_of_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace raylab::cornell {

namespace {

constexpr std::size_t parts = 8;
constexpr std::array<const char*, parts> names{"floor",    "ceiling", "back wall",   "green wall",
                                               "red wall", "light",   "short block", "tall block"};
constexpr std::array<const char*, parts> fills{"#ffffff", "#ffffff", "#ffffff", "#c8ecc8",
                                               "#f6c4c0", "#fff3b0", "#ffffff", "#ffffff"};

// The scene's objects are the six polygons in this order, and five of each block.
std::size_t part_of(const SceneRadiosity& solved, std::size_t patch) {
    const std::size_t object = solved.mesh->model.facets[solved.mesh->patches[patch].facet].object;
    return object < 6 ? object : object < 11 ? 6 : 7;
}

}  // namespace

Diagram exchange_diagram(const SceneRadiosity& solved) {
    constexpr std::size_t shown = 10;
    struct Exchange {
        std::size_t from, to;
        double power = 0;
    };
    std::vector<Exchange> exchanges;
    for (std::size_t from = 0; from < parts; ++from)
        for (std::size_t to = 0; to < parts; ++to) exchanges.push_back({from, to});
    std::array<double, parts> leaving{};
    const RadiositySystem& system = solved.system;
    for (std::size_t i = 0; i < system.patches(); ++i) {
        const std::size_t from = part_of(solved, i);
        const double power = system.area[i] * mean_of_channels(solved.solution.radiosity[i]);  // watts
        leaving[from] += power;
        for (std::size_t j = 0; j < system.patches(); ++j)
            exchanges[from * parts + part_of(solved, j)].power += power * system.form_factors.at(i, j);
    }
    std::ranges::stable_sort(exchanges, std::ranges::greater(), &Exchange::power);

    Diagram diagram{
        .title = fmt::format("The {} strongest exchanges of light in the Cornell box, in milliwatts", shown),
        .nodes = {},
        .edges = {}};
    for (std::size_t part = 0; part < parts; ++part)
        diagram.nodes.push_back({.label = fmt::format("{}\n{:.0f} mW leave", names[part], 1000 * leaving[part]),
                                 .fill = fills[part],
                                 .font = 13});
    for (std::size_t i = 0; i < shown; ++i)
        diagram.edges.push_back({.from = exchanges[i].from,
                                 .to = exchanges[i].to,
                                 .label = fmt::format("{:.0f}", 1000 * exchanges[i].power),
                                 .pen = 0.5 + 4.5 * exchanges[i].power / exchanges.front().power});
    return diagram;
}

}  // namespace raylab::cornell
