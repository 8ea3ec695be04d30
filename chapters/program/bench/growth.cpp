#include "growth.h"

#include "raylab/report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace raylab::bench {

namespace {

/// The cost of one peer on one mesh, over the kinds of rays.
StructureCost cost_of(const std::vector<Row>& rows) {
    const Row& any = rows.front();
    const auto mean = [&](const auto& quantity) {
        double sum = 0;
        for (const Row& row : rows) sum += quantity(row);
        return sum / static_cast<double>(rows.size());
    };
    const auto nanoseconds = [&](double Row::*speed) {
        return std::exp(mean([&](const Row& row) { return std::log(1e9 / row.*speed); }));
    };
    return {.structure = any.peer,
            .family = "all rays",
            .primitives = any.triangles,
            .rays = any.ray_count,
            .build_seconds = any.build_seconds,
            .bytes = static_cast<double>(any.bytes) / static_cast<double>(any.triangles),
            .nanoseconds = {nanoseconds(&Row::rays_per_second), nanoseconds(&Row::fastest), nanoseconds(&Row::slowest)},
            .primitive_tests = mean([](const Row& row) { return row.work.primitive_tests; }),
            .box_tests = mean([](const Row& row) { return row.work.box_tests; }),
            .steps = mean([](const Row& row) { return row.work.steps; })};
}

std::vector<std::string> structures(const std::vector<StructureCost>& costs) {
    std::vector<std::string> names;
    for (const StructureCost& cost : costs)
        if (std::ranges::find(names, cost.structure) == names.end()) names.push_back(cost.structure);
    return names;
}

}  // namespace

std::vector<StructureCost> growth(const std::vector<Row>& rows) {
    std::vector<std::string> peers;
    std::map<std::string, std::map<std::size_t, std::vector<Row>>> sorted;  // by peer and by size
    for (const Row& row : rows) {
        if (row.threads != rows.front().threads) continue;
        if (!sorted.contains(row.peer)) peers.push_back(row.peer);
        sorted[row.peer][row.triangles].push_back(row);
    }
    std::vector<StructureCost> costs;
    for (const std::string& peer : peers)
        for (const auto& [triangles, of_mesh] : sorted[peer]) costs.push_back(cost_of(of_mesh));
    return costs;
}

std::string growth_table(const std::vector<StructureCost>& costs) {
    std::set<std::size_t> sizes;
    for (const StructureCost& cost : costs) sizes.insert(cost.primitives);
    std::vector<std::string> header = {"triangles"};
    for (const std::size_t size : sizes) header.push_back(fmt::format("{}", size));
    header.push_back("last / first");
    std::vector<std::vector<std::string>> lines;
    const auto add = [&](const std::string& structure, const std::string& what,
                         const std::function<double(const StructureCost&)>& value) {
        std::vector<std::string> line = {structure + ": " + what};
        double first = 0, last = 0;
        for (const StructureCost& cost : costs) {
            if (cost.structure != structure) continue;
            last = value(cost);
            if (line.size() == 1) first = last;
            line.push_back(number_text(last));
        }
        if (!(first > 0)) return;  // the peer has no such count
        line.push_back(fmt::format("{:.2f}", last / first));
        lines.push_back(line);
    };
    for (const std::string& name : structures(costs)) {
        add(name, "Mrays/s", [](const StructureCost& cost) { return 1e3 / cost.nanoseconds.median; });
        add(name, "nodes a ray", [](const StructureCost& cost) { return cost.steps; });
        add(name, "triangles a ray", [](const StructureCost& cost) { return cost.primitive_tests; });
    }
    return "cost against size, means over the kinds of rays\n" + text_table(header, lines);
}

void write_growth_charts(const std::vector<StructureCost>& costs, const std::filesystem::path& folder) {
    const std::pair<const char*, GrowthOf> charts[] = {{"growth_rays", GrowthOf::rays_per_second},
                                                       {"growth_steps", GrowthOf::steps},
                                                       {"growth_tests", GrowthOf::primitive_tests},
                                                       {"growth_build", GrowthOf::build_time},
                                                       {"growth_bytes", GrowthOf::bytes}};
    for (const auto& [name, what] : charts) write_chart(growth_chart(costs, what), folder, name);
}

}  // namespace raylab::bench
