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

Price promised() {
    static const std::regex sentence(
        R"(its price is measured: ([0-9.]+) times the fastest plain method's time on\s+)"
        R"(generic rays at a triangle, ([0-9.]+) times where every ray aims at a vertex\s+)"
        R"(\(`\./raylab chart ray_triangle`\))");
    const auto readme = read_file(source / "README.md");
    std::smatch found;
    REQUIRE(std::regex_search(readme, found, sentence));
    return {std::stod(found[1]), std::stod(found[2])};
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

// Another processor, or one that others use too, shifts times, but hardly their ratio.
TEST_CASE("README's price of exactness is what the chart measures, within a factor of 1.6") {
    constexpr double band = 1.6;
    const auto [generic, vertex] = promised();
    const auto here = measured();
    INFO("README: " << generic << " and " << vertex << " times; here: " << here.generic << " and " << here.vertex);
    CHECK((here.generic < band * generic && here.generic > generic / band));
    CHECK((here.vertex < band * vertex && here.vertex > vertex / band));
}
