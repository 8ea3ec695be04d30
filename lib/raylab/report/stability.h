#pragma once

#include <functional>
#include <string>
#include <vector>

namespace raylab {

/// One line of a stability case: what one method did where it was expected to fail or to hold.
struct CaseRow {
    std::string method;    // "Moeller-Trumbore, float"
    std::string expected;  // "leaks > 1 %"
    std::string observed;  // "leaks 9.2 %"
    bool as_expected = false;  // a weak method that does *not* fail is a broken case: false
};

/// A named case where methods fail, with the outcome that is expected, failure included.
struct StabilityCase {
    std::string name;   // "EDGE-SHOT"
    std::string about;  // what is done, and why it is hard
    std::function<std::vector<CaseRow>()> run;
};

/// A case that has been run.
struct CaseOutcome {
    std::string name, about;
    std::vector<CaseRow> rows;
    bool as_expected() const;  // every row, and at least one row
};

CaseOutcome run(const StabilityCase& stability_case);

/// "✓ as expected" or "✗ not as expected".
std::string verdict_text(const CaseRow& row);

/// A table for people, one line a row, verdicts in words.
std::string to_text(const std::vector<CaseOutcome>& outcomes);

/// [{"name", "about", "as_expected", "rows": [{"method", "expected", "observed", "as_expected"}]}]
std::string to_json(const std::vector<CaseOutcome>& outcomes);

}  // namespace raylab
