#pragma once

#include "raylab/report/measure.h"
#include "raylab/report/provenance.h"
#include "raylab/report/stability.h"

#include <filesystem>
#include <string>
#include <vector>

// The pieces a page of the lab book is made of, as HTML. `folder` is where the page stands: pictures are looked at there.

namespace raylab {

/// A picture beside its page, with what it shows.
std::string picture_html(const std::filesystem::path& folder, const std::string& file, const std::string& shows);

/// Whether a file is drawn (.svg) or rendered (.png): a drawing stands on white paper in dark mode too.
bool is_drawing(const std::string& file);

std::string table_html(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                       const std::string& caption);

/// The chart, the errors of each method on each workload at a glance, and all numbers to unfold.
std::string experiment_html(const std::filesystem::path& folder, const Experiment& experiment,
                            const std::string& chart_name);

std::string stability_html(const std::vector<CaseOutcome>& outcomes);

/// "✓ 11 of 11 cases as expected", as a coloured chip.
std::string verdict_chip(std::size_t as_expected, std::size_t total);

std::string facts_html(const std::vector<Fact>& facts);

/// A whole page around `body`; `navigation` stands at its top and its end.
std::string whole_page(const std::string& title, const std::string& navigation, const std::string& body);

}  // namespace raylab
