#include "results.h"

#include "raylab/report/table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace raylab::bench {

namespace {

bool same_entrant(const Row& a, const Row& b) { return a.peer == b.peer && a.threads == b.threads; }

/// The first row of each entrant, in order.
std::vector<Row> entrants(const std::vector<Row>& rows) {
    std::vector<Row> first;
    for (const Row& row : rows)
        if (std::ranges::none_of(first, [&](const Row& one) { return same_entrant(one, row); })) first.push_back(row);
    return first;
}

std::string name(const Row& row) {
    return row.threads == 1 ? row.peer : fmt::format("{}, {} threads", row.peer, row.threads);
}

/// The geometric mean of a quantity's ratio, over the matching rows of both; "" where there are none.
template <class Quantity, class Counts>
std::string mean_ratio(const std::vector<Row>& rows, const Row& entrant, const Row& base, const Quantity& quantity,
                       const Counts& counts) {
    double sum = 0;
    int count = 0;
    for (const Row& row : rows) {
        if (!same_entrant(row, entrant) || !counts(row)) continue;
        for (const Row& other : rows) {
            if (!same_entrant(other, base) || other.mesh != row.mesh || other.rays != row.rays) continue;
            sum += std::log(quantity(row) / quantity(other));
            ++count;
        }
    }
    const double mean = count > 0 ? std::exp(sum / count) : 0;
    return count == 0 ? "" : mean < 0.095 ? fmt::format("{:.2g}", mean) : fmt::format("{:.2f}", mean);
}

}  // namespace

nlohmann::ordered_json to_json(const std::vector<Row>& rows) {
    auto json = nlohmann::ordered_json::array();
    for (const Row& row : rows)
        json.push_back({{"mesh", row.mesh},
                        {"triangles", row.triangles},
                        {"rays", row.rays},
                        {"question", row.question == RayQuestion::any ? "any" : "closest"},
                        {"peer", row.peer},
                        {"threads", row.threads},
                        {"rays_per_second", row.rays_per_second},
                        {"slowest", row.slowest},
                        {"fastest", row.fastest},
                        {"build_seconds", row.build_seconds},
                        {"bytes", row.bytes},
                        {"wrong", row.wrong},
                        {"other_triangle", row.other},
                        {"ray_count", row.ray_count},
                        {"hits", row.hits},
                        {"steps", row.work.steps},
                        {"box_tests", row.work.box_tests},
                        {"primitive_tests", row.work.primitive_tests},
                        {"exact_decisions", row.work.exact_decisions}});
    return json;
}

std::string mesh_table(const std::vector<Row>& rows) {
    std::vector<std::string> header = {"Mrays/s"};
    for (const Row& row : rows)
        if (same_entrant(row, rows.front())) header.push_back(row.rays);
    header.insert(header.end(), {"build ms", "B/triangle", "wrong"});
    std::vector<std::vector<std::string>> lines;
    for (const Row& entrant : entrants(rows)) {
        std::vector<std::string> line = {name(entrant)};
        std::size_t wrong = 0;
        for (const Row& row : rows) {
            if (!same_entrant(row, entrant)) continue;
            line.push_back(fmt::format("{:.3g}", row.rays_per_second * 1e-6));
            wrong += row.wrong;
        }
        line.push_back(fmt::format("{:.1f}", entrant.build_seconds * 1e3));
        line.push_back(
            fmt::format("{:.0f}", static_cast<double>(entrant.bytes) / static_cast<double>(entrant.triangles)));
        line.push_back(fmt::format("{}", wrong));
        lines.push_back(line);
    }
    return fmt::format("{}, {} triangles\n", rows.front().mesh, rows.front().triangles) + text_table(header, lines);
}

std::string summary_table(const std::vector<Row>& rows) {
    const auto speed = [](const Row& row) { return row.rays_per_second; };
    const auto closest = [](const Row& row) { return row.question == RayQuestion::nearest; };
    const auto any = [](const Row& row) { return row.question == RayQuestion::any; };
    const auto every = [](const Row&) { return true; };
    const auto all = entrants(rows);
    std::vector<std::vector<std::string>> lines;
    for (const Row& entrant : all) {
        // Compared with the first peer with as many threads; several threads with one thread of the same peer.
        const Row& base = *std::ranges::find(all, entrant.threads, &Row::threads);
        const Row& alone = *std::ranges::find(all, entrant.peer, &Row::peer);
        lines.push_back({name(entrant), mean_ratio(rows, entrant, base, speed, closest),
                         mean_ratio(rows, entrant, base, speed, any),
                         mean_ratio(
                             rows, entrant, base, [](const Row& row) { return row.build_seconds; }, every),
                         mean_ratio(
                             rows, entrant, base, [](const Row& row) { return static_cast<double>(row.bytes); }, every),
                         mean_ratio(rows, entrant, alone, speed, every)});
    }
    return fmt::format("geometric means over meshes and rays, {} = 1\n", all.front().peer) +
           text_table({"", "closest", "any", "build time", "bytes", "speed-up by threads"}, lines);
}

}  // namespace raylab::bench
