#include "raylab/report/stability.h"

#include "raylab/report/json_text.h"
#include "raylab/report/table.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace raylab {

bool CaseOutcome::as_expected() const { return !rows.empty() && std::ranges::all_of(rows, &CaseRow::as_expected); }

CaseOutcome run(const StabilityCase& stability_case) {
    return {stability_case.name, stability_case.about, stability_case.run()};
}

std::string verdict_text(const CaseRow& row) { return row.as_expected ? "✓ as expected" : "✗ not as expected"; }

std::string to_text(const std::vector<CaseOutcome>& outcomes) {
    std::string text;
    for (const auto& outcome : outcomes) {
        std::vector<std::vector<std::string>> rows;
        for (const auto& row : outcome.rows)
            rows.push_back({row.method, row.expected, row.observed, verdict_text(row)});
        text += outcome.name + ": " + outcome.about + "\n";
        text += rows.empty() ? "  ✗ not as expected: the case has no rows\n"
                             : text_table({"method", "expected", "observed", "verdict"}, rows);
        text += "\n";
    }
    const auto good = std::ranges::count_if(outcomes, &CaseOutcome::as_expected);
    return text + std::to_string(good) + " of " + std::to_string(outcomes.size()) + " cases as expected\n";
}

std::string to_json(const std::vector<CaseOutcome>& outcomes) {
    auto cases = nlohmann::ordered_json::array();
    for (const auto& outcome : outcomes) {
        auto rows = nlohmann::ordered_json::array();
        for (const auto& row : outcome.rows)
            rows.push_back({{"method", row.method},
                            {"expected", row.expected},
                            {"observed", row.observed},
                            {"as_expected", row.as_expected}});
        cases.push_back(
            {{"name", outcome.name}, {"about", outcome.about}, {"as_expected", outcome.as_expected()}, {"rows", rows}});
    }
    return json_text(cases);
}

}  // namespace raylab
