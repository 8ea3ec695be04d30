#include "kinds.h"

#include "mean_ratio.h"
#include "meshes.h"
#include "options.h"

#include "raylab/report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace raylab::bench {

namespace {

std::vector<std::string> kinds_in(const std::vector<Row>& rows) {
    std::vector<std::string> kinds;
    for (const Row& row : rows)
        if (const auto kind = kind_of_mesh(row.mesh); std::ranges::find(kinds, kind) == kinds.end())
            kinds.push_back(kind);
    return kinds;
}

// The peers that raced with as many threads as the first, in order.
std::vector<Racer> racers_in(const std::vector<Row>& rows) {
    std::vector<Racer> racers;
    for (const Row& row : rows)
        if (row.threads == rows.front().threads && std::ranges::find(racers, racer(row)) == racers.end())
            racers.push_back(racer(row));
    return racers;
}

std::optional<Racer> racer_named(const std::vector<Row>& rows, std::string_view name) {
    const auto racers = racers_in(rows);
    const auto found = std::ranges::find(racers, name, &Racer::peer);
    return found == racers.end() ? std::nullopt : std::optional(*found);
}

std::optional<double> of_kind(const std::vector<Row>& rows, const std::string& kind, const Racer& one,
                              const Racer& base, const Quantity& quantity, const Counts& counts) {
    return mean_ratio(rows, one, base, quantity,
                      [&](const Row& row) { return counts(row) && kind_of_mesh(row.mesh) == kind; });
}

// The geometric mean over the kinds, and the smallest of them.
struct OverKinds {
    double mean, least;
};
OverKinds over_kinds(const std::vector<Row>& rows, const Racer& one, const Racer& base, const Quantity& quantity,
                     const Counts& counts) {
    double sum = 0, least = std::numeric_limits<double>::infinity();
    const auto kinds = kinds_in(rows);
    for (const auto& kind : kinds) {
        const double ratio =
            of_kind(rows, kind, one, base, quantity, counts).value_or(std::numeric_limits<double>::quiet_NaN());
        sum += std::log(ratio);
        least = std::min(least, ratio);
    }
    return {std::exp(sum / static_cast<double>(kinds.size())), least};
}

/// What is to be reached, and what was.
struct Goal {
    std::string what;
    enum class Sign { at_least, at_most } sign;
    double goal, found;

    bool is_reached() const { return sign == Sign::at_least ? found >= goal : found <= goal; }
    std::vector<std::string> line() const {
        return {what, fmt::format("{:.2f}", found),
                fmt::format("{} {:.2f}", sign == Sign::at_least ? "at least" : "at most", goal),
                std::isnan(found) ? "not measured"
                : is_reached()    ? "reached"
                                  : "missed"};
    }
};

std::vector<Goal> goals_of(const std::vector<Row>& rows, const Racer& ours, const Racer& high,
                           const std::optional<Racer>& medium) {
    using enum Goal::Sign;
    std::vector<Goal> goals;
    for (const auto& [question, counts] :
         {std::pair<std::string, Counts>{"closest hit", is_closest}, {"any hit", is_any}}) {
        const auto found = over_kinds(rows, ours, high, speed_of, counts);
        goals.push_back({question + ": rays a second over embree_high's, mean over kinds", at_least, 1, found.mean});
        goals.push_back({question + ": the same, on the kind where it is least", at_least, 0.95, found.least});
    }
    if (ours.peer.starts_with("bvh8_splits"))
        goals.push_back({"build time over embree_high's", at_most, 0.5,
                         over_kinds(rows, ours, high, build_time_of, is_timed).mean});
    else if (medium)
        goals.push_back({"build time over embree_default's", at_most, 1,
                         over_kinds(rows, ours, *medium, build_time_of, is_timed).mean});
    goals.push_back({"bytes over embree_high's", at_most, 0.8, over_kinds(rows, ours, high, bytes_of, is_timed).mean});
    std::size_t wrong = 0;
    for (const Row& row : rows)
        if (racer(row) == ours) wrong += row.wrong;
    goals.push_back({"wrong hit decisions", at_most, 0, static_cast<double>(wrong)});
    return goals;
}

}  // namespace

std::string kinds_table(const std::vector<Row>& rows) {
    const auto racers = racers_in(rows);
    const Racer base = racer_named(rows, other_peer::embree_high.name).value_or(racers.front());
    std::vector<std::vector<std::string>> lines;
    for (const std::string& kind : kinds_in(rows))
        for (const Racer& one : racers) {
            const auto text = [&](const Quantity& quantity, const Counts& counts) {
                return ratio_text(of_kind(rows, kind, one, base, quantity, counts));
            };
            lines.push_back({kind, one.peer, text(speed_of, is_closest), text(speed_of, is_any),
                             text(build_time_of, is_timed), text(bytes_of, is_timed)});
        }
    return fmt::format("geometric means by kinds of meshes, {} = 1\n", base.peer) +
           text_table({"meshes", "", "closest", "any", "build time", "bytes"}, lines);
}

std::string goals_table(const std::vector<Row>& rows) {
    const auto high = racer_named(rows, other_peer::embree_high.name),
               medium = racer_named(rows, other_peer::embree_default.name);
    if (!high) return "";
    std::string text;
    for (const Racer& one : racers_in(rows)) {
        if (one.peer != "auto" && !one.peer.starts_with("bvh8")) continue;
        if (one.peer == other_peer::bvh8_plain.name) continue;
        std::vector<std::vector<std::string>> lines;
        for (const Goal& goal : goals_of(rows, one, *high, medium)) lines.push_back(goal.line());
        text += "\n" + text_table({one.peer, "", "goal", ""}, lines);
    }
    return text;
}

}  // namespace raylab::bench
