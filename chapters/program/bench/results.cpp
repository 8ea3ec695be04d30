#include "results.h"

#include "mean_ratio.h"

#include "raylab/report/table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace raylab::bench {

namespace {

bool same_entrant(const Row& a, const Row& b) { return racer(a) == racer(b); }

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
    const auto all = entrants(rows);
    std::vector<std::vector<std::string>> lines;
    for (const Row& entrant : all) {
        // Compared with the first peer with as many threads; several threads with one thread of the same peer.
        const Row& base = *std::ranges::find(all, entrant.threads, &Row::threads);
        const Row& alone = *std::ranges::find(all, entrant.peer, &Row::peer);
        const auto text = [&](const Row& against, const Quantity& quantity, const Counts& counts) {
            return ratio_text(mean_ratio(rows, racer(entrant), racer(against), quantity, counts));
        };
        lines.push_back({name(entrant), text(base, speed_of, is_closest), text(base, speed_of, is_any),
                         text(base, build_time_of, is_timed), text(base, bytes_of, is_timed),
                         text(alone, speed_of, is_timed)});
    }
    return fmt::format("geometric means over meshes and rays, {} = 1\n", all.front().peer) +
           text_table({"", "closest", "any", "build time", "bytes", "speed-up by threads"}, lines);
}

}  // namespace raylab::bench
