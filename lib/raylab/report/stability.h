#pragma once

#include "raylab/report/plane/plane_drawing.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace raylab {

/// The truth about a query that a method decides wrongly.
enum class TrueAnswer { hit, miss };

/// A single query that shows how a method fails.
struct CaseExample {
    std::string words;  // its numbers, as they can be read back
    PlaneDrawing drawing;
};

/// One row of a stability case: the result of one method where it was expected to fail or to hold.
struct CaseRow {
    std::string method;        // "Moeller-Trumbore, float"
    std::string expected;      // "fails: more than 1 % leak", "holds: none wrong", "nothing: shown, not judged"
    std::string observed;      // "9.2 % leak"
    bool as_expected = false;  // false also for a weak method that does *not* fail, because such a case shows nothing
    std::optional<CaseExample> example = {};
};

/// What is expected of a row: the first word of CaseRow::expected.
enum class Expectation { fails, holds, nothing };
Expectation expectation_of(const CaseRow& row);

/// What CaseRow::expected says behind its first word: "more than 1 % leak".
std::string expected_words(const CaseRow& row);

/// What a case is about, drawn with as few marks as show it, for a page that shows it small.
struct CaseSketch {
    std::string caption;  // what is to be seen in it
    PlaneDrawing drawing;
};

/// A named case in which methods fail, with the expected outcome of each method; the expectation may be a failure.
struct StabilityCase {
    std::string name;   // "EDGE-SHOT"
    std::string about;  // what is done, and why it is hard
    std::function<std::vector<CaseRow>()> run;
    std::function<CaseSketch()> sketch = {};  // why it is hard; needed where no row has an example
};

/// A case that has been run.
struct CaseOutcome {
    std::string name, about;
    std::vector<CaseRow> rows;
    std::optional<CaseSketch> sketch = {};
    bool as_expected() const;  // whether every row is as expected, and there is one at all
};

/// Every row that it returns says what is expected of it.
CaseOutcome run(const StabilityCase& stability_case);

/// "✗ fails, as expected", "✓ holds", "not judged", "‼ HOLDS, should fail" or "‼ FAILS, should hold".
std::string verdict_text(const CaseRow& row);

/// A table for people, with one line for each row and the verdicts in words.
std::string to_text(const std::vector<CaseOutcome>& outcomes);

/// The outcomes as JSON: [{"name", "about", "as_expected", "rows": [{"method", "expected", "observed",
/// "as_expected",
/// "example"}]}]; an example is there where one is known.
std::string to_json(const std::vector<CaseOutcome>& outcomes);

}  // namespace raylab
