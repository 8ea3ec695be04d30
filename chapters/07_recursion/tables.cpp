#include "tables.h"

#include "rooms.h"
#include "termination.h"

#include <fmt/format.h>

#include <utility>

namespace raylab::recursion {

namespace {

std::string share(const Endings& found, Ending ending) {
    return found.percent.contains(ending) ? fmt::format("{:.1f} %", found.percent.at(ending)) : "-";
}

std::string brightness(double rho, int depth) {
    return fmt::format("{:.6f}", hall_of_mirrors(rho).brightness({.depth = depth}));
}

}  // namespace

std::vector<std::string> endings_header() {
    return {"", "rays a pixel", "diffuse", "nothing there", "total internal reflection", "depth", "throughput"};
}

Rows endings_rows(const Scene& scene, int threads) {
    Rows rows;
    for (const auto& [name, options] :
         {std::pair{"depth 5", WhittedOptions{.depth = 5}}, std::pair{"depth 10", WhittedOptions{.depth = 10}},
          std::pair{"depth 10, throughput above 0.01", WhittedOptions{.depth = 10, .threshold = 0.01}}}) {
        const Endings found = endings(scene, options, threads);
        rows.push_back({name, fmt::format("{:.2f}", found.rays_a_pixel), share(found, Ending::diffuse),
                        share(found, Ending::missed), share(found, Ending::total_internal_reflection),
                        share(found, Ending::depth), share(found, Ending::threshold)});
    }
    return rows;
}

Rows hall_of_mirrors_rows() {
    Rows rows;
    for (const int depth : {1, 2, 3, 5, 10, 20, 40})
        rows.push_back({std::to_string(depth), brightness(0.5, depth), brightness(0.9, depth)});
    rows.push_back({"truth", fmt::format("{:.6f}", hall_of_mirrors_truth(0.5)),
                    fmt::format("{:.6f}", hall_of_mirrors_truth(0.9))});
    return rows;
}

}  // namespace raylab::recursion
