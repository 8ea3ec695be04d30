#include "raylab/report/stability.h"

#include "raylab/report/json_text.h"
#include "raylab/report/table.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cassert>

namespace raylab {

bool CaseOutcome::as_expected() const { return !rows.empty() && std::ranges::all_of(rows, &CaseRow::as_expected); }

Expectation expectation_of(const CaseRow& row) {
    if (row.expected.starts_with("fails: ")) return Expectation::fails;
    if (row.expected.starts_with("holds: ")) return Expectation::holds;
    assert(row.expected.starts_with("nothing: "));
    return Expectation::nothing;
}

std::string expected_words(const CaseRow& row) { return row.expected.substr(row.expected.find(": ") + 2); }

CaseOutcome run(const StabilityCase& stability_case) {
    CaseOutcome outcome{stability_case.name, stability_case.about, stability_case.run()};
    if (stability_case.sketch) outcome.sketch = stability_case.sketch();
    return outcome;
}

std::string verdict_text(const CaseRow& row) {
    switch (expectation_of(row)) {
        case Expectation::fails:
            return row.as_expected ? "✗ fails, as expected" : "‼ HOLDS, should fail";
        case Expectation::holds:
            return row.as_expected ? "✓ holds" : "‼ FAILS, should hold";
        case Expectation::nothing:
            break;
    }
    return "not judged";
}

std::string to_text(const std::vector<CaseOutcome>& outcomes) {
    std::string text;
    for (const auto& outcome : outcomes) {
        std::vector<std::vector<std::string>> rows;
        for (const auto& row : outcome.rows)
            rows.push_back({verdict_text(row), row.method, expected_words(row), row.observed});
        for (const auto& line : wrapped(outcome.name + ": " + outcome.about, terminal_width)) text += line + "\n";
        text += rows.empty() ? "  ‼ NOT AS EXPECTED: the case has no rows\n"
                             : text_table({"verdict", "method", "expected", "observed"}, rows);
        text += "\n";
    }
    const auto good = std::ranges::count_if(outcomes, &CaseOutcome::as_expected);
    return text + std::to_string(good) + " of " + std::to_string(outcomes.size()) + " cases as expected\n";
}

std::string to_json(const std::vector<CaseOutcome>& outcomes) {
    auto cases = nlohmann::ordered_json::array();
    for (const auto& outcome : outcomes) {
        auto rows = nlohmann::ordered_json::array();
        for (const auto& row : outcome.rows) {
            rows.push_back({{"method", row.method},
                            {"expected", row.expected},
                            {"observed", row.observed},
                            {"as_expected", row.as_expected}});
            if (row.example) rows.back()["example"] = row.example->words;
        }
        cases.push_back(
            {{"name", outcome.name}, {"about", outcome.about}, {"as_expected", outcome.as_expected()}, {"rows", rows}});
    }
    return json_text(cases);
}

}  // namespace raylab
