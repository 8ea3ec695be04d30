#include "raylab/report/chart/decision_chart.h"

#include "catch.h"
#include "raylab/report/chart/broken_axis.h"
#include "raylab/report/chart/share_color.h"
#include "raylab/report/chart/tradeoff_chart.h"

#include <regex>
#include <set>

using namespace raylab;

namespace {

Measurement decided(const std::string& method, const std::string& workload, double error, const Spread& time) {
    return {.method = method,
            .number = "double",
            .workload = workload,
            .source = "a paper <1>",
            .error = error,
            .error_bound = 30,
            .nanoseconds = time,
            .queries = 100'000};
}

Experiment decisions() {
    return {"q",
            "Q?",
            "wrong decisions [ppm]",
            {decided("plain", "easy", 12, {5, 4.9, 5.1}), decided("plain", "hard", 810'000, {5, 4.9, 5.1}),
             decided("exact", "easy", 0, {9, 8.8, 9.2}), decided("exact", "hard", 0, {9, 8.8, 9.2}),
             decided("other", "easy", 0, {40, 39, 41}), decided("other", "hard", 0, {9.1, 8.9, 9.3})}};
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

const std::string framed = "fill=\"none\" stroke=\"#222222\" stroke-width=\"2.00\"";
const std::string bracket = "fill=\"none\" stroke=\"#222222\" stroke-width=\"1.50\"";

}  // namespace

TEST_CASE("a heat table says each share as people do, and a mark says method, workload, error, time and source") {
    const auto svg = to_svg(decision_chart(decisions()));
    for (const auto* words : {">0<", ">12 ppm<", ">81 %<"}) CHECK(svg.find(words) != std::string::npos);
    CHECK(svg.find("data-method=\"plain\" data-number=\"double\" data-knob=\"\" data-workload=\"hard\" "
                   "data-error=\"810000\" data-nanoseconds=\"5\" data-queries=\"100000\" "
                   "data-source=\"a paper &lt;1&gt;\"") != std::string::npos);
    CHECK(count_of(svg, "data-method") == 12);  // a cell and a mark for each measurement
    CHECK(
        svg.find("plain, double\nhard\nwrong decisions: 81 %\n5 ns a query (quartiles 4.9 to 5.1)\n100 000 queries") !=
        std::string::npos);
}

TEST_CASE("the front is framed, and a bracket joins a tie") {
    // On the easy workload plain and exact are on the front; on the hard one plain is too wrong, and the others tie.
    const auto svg = to_svg(decision_chart(decisions()));
    CHECK(count_of(svg, framed) == 4);
    CHECK(count_of(svg, bracket) == 3);  // one line, and a tick at each of two rows
    auto apart = decisions();
    apart.rows[5].nanoseconds = {20, 19, 21};
    CHECK(count_of(to_svg(decision_chart(apart)), framed) == 3);
    CHECK(count_of(to_svg(decision_chart(apart)), bracket) == 0);
}

TEST_CASE("the best method comes first, and what was not measured is a dash") {
    auto experiment = decisions();
    experiment.rows.pop_back();
    const auto svg = to_svg(decision_chart(experiment));
    CHECK(svg.find(">–<") != std::string::npos);
    CHECK(svg.find("exact</tspan>") < svg.find(">plain<"));
}

TEST_CASE("no chart has text smaller than 11 pixels, or wider than 1280") {
    auto ulps = decisions();
    ulps.error_axis = "error of t [ulp]";
    for (const auto& drawing : {decision_chart(decisions()), tradeoff_chart(ulps)}) {
        const auto svg = to_svg(drawing);
        CHECK(drawing.width <= 1280);
        const std::regex size("font-size=\"([0-9.]+)\"");
        for (std::sregex_iterator found(svg.begin(), svg.end(), size), end; found != end; ++found)
            CHECK(std::stod((*found)[1]) >= 11);
    }
}

TEST_CASE("the cells of each decade have a colour of their own, and text on them is legible") {
    std::set<std::string> colors;
    for (const double share : {0.0, 5e-7, 5e-6, 5e-5, 5e-4, 5e-3, 5e-2, 0.5}) {
        const auto color = share_color(share);
        CHECK(contrast_ratio(color.back, color.text) >= 4.5);
        colors.insert(color.back);
    }
    CHECK(colors.size() == 8);
    CHECK(share_color(1).back == share_color(0.1).back);
    CHECK(share_color(0.0999).back != share_color(0.1).back);
    CHECK_THAT(contrast_ratio("#000000", "#ffffff"), WithinRel(21.0, 1e-12));
}

TEST_CASE("an axis is broken before few values that are far above all others, and nowhere else") {
    const std::vector<double> near = {1, 2, 3, 5, 8, 10, 12, 15};
    CHECK_FALSE(broken_axis_for(near, 0.1).beyond);
    auto far = near;
    far.push_back(5000);
    const auto broken = broken_axis_for(far, 0.1);
    REQUIRE(broken.beyond);
    CHECK(broken.share(15) < BrokenAxis::main_share);
    CHECK(broken.share(5000) > BrokenAxis::main_share + BrokenAxis::gap_share);
    CHECK(broken.share(5000) <= 1);
    CHECK_FALSE(broken_axis_for({1, 2, 5000, 6000, 7000}, 0.1).beyond);  // three of five are no outliers
    CHECK_FALSE(broken_axis_for({1, 10, 100, 1000, 10'000, 100'000}, 0.1).beyond);
    CHECK_FALSE(broken_axis_for({}, 0.1).beyond);
}
