#include "catch.h"

#include "raylab/base/file.h"
#include "raylab/base/process.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <regex>
#include <string>

// README's sentence about what exact decisions cost, compared with what its command measures here.

namespace fs = std::filesystem;
using namespace raylab;

namespace {

const fs::path source = RAYLAB_SOURCE;

struct Price {
    double generic, vertex;  // the time of the filtered exact method, in times of the fastest other one
};

struct PriceRange {
    Price least, most;

    bool has(const Price& price) const {
        constexpr double band = 1.3;  // another processor shifts times, but hardly their ratio
        return price.generic > least.generic / band && price.generic < band * most.generic &&
               price.vertex > least.vertex / band && price.vertex < band * most.vertex;
    }
};

PriceRange promised() {
    static const std::regex sentence(
        R"(its price is measured: ([0-9.]+) to ([0-9.]+) times the fastest plain method's time on\s+)"
        R"(generic rays at a triangle, ([0-9.]+) to ([0-9.]+) times where every ray aims at a vertex\s+)"
        R"(\(`\./raylab chart ray_triangle`)");
    const auto readme = read_file(source / "README.md");
    std::smatch found;
    REQUIRE(std::regex_search(readme, found, sentence));
    return {{std::stod(found[1]), std::stod(found[3])}, {std::stod(found[2]), std::stod(found[4])}};
}

double price_on(const nlohmann::json& rows, const std::string& workload) {
    double exact = 0, fastest = std::numeric_limits<double>::infinity();
    for (const auto& row : rows) {
        if (row.at("workload") != workload) continue;
        const double time = row.at("nanoseconds").at("median");
        if (row.at("method") == "filtered exact")
            exact = time;
        else
            fastest = std::min(fastest, time);
    }
    REQUIRE(exact > 0);
    return exact / fastest;
}

Price measured() {
    const auto result =
        run_process(fs::path(RAYLAB_BUILD) / "raylab", {"chart", "ray_triangle", "--quick", "--json", "-"},
                    {.folder = source, .timeout = 120});
    INFO(result.errors);
    REQUIRE(result.code == 0);
    const auto rows = nlohmann::json::parse(result.output).at("rows");
    return {price_on(rows, "generic"), price_on(rows, "vertex")};
}

}  // namespace

TEST_CASE("README's price of exactness is what the chart measures") {
    constexpr int runs = 3;  // a busy machine shifts the ratio, too
    const auto range = promised();
    Price here = measured();
    for (int run = 1; run < runs && !range.has(here); ++run) here = measured();
    INFO("here: " << here.generic << " times on generic rays and " << here.vertex << " times at a vertex");
    CHECK(range.has(here));
}
