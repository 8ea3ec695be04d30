#pragma once

#include "raylab/experiment/measure/measure.h"
#include "raylab/report/provenance.h"
#include "raylab/report/stability.h"

#include <filesystem>
#include <string>
#include <vector>

// The parts of a page of the lab book, as HTML. `folder` is the page's folder, in which the pictures' sizes are looked
// up.

namespace raylab {

/// A picture file beside its page, with its caption.
std::string picture_html(const std::filesystem::path& folder, const std::string& file, const std::string& shows);

/// Whether a picture is drawn (.svg) or rendered (.png): a drawing has a white background in dark mode too.
bool is_drawing(const std::string& file);

std::string table_html(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                       const std::string& caption);

/// The chart, a table of the errors of each method on each workload, and all numbers in a part that can be unfolded.
std::string experiment_html(const std::filesystem::path& folder, const Experiment& experiment,
                            const std::string& chart_name);

std::string stability_html(const std::vector<CaseOutcome>& outcomes);

/// A coloured label such as "✓ 11 of 11 cases as expected".
std::string verdict_chip(std::size_t as_expected, std::size_t total);

std::string facts_html(const std::vector<Fact>& facts);

/// The navigation of a page that has no chapters beside it: to the book's front page, whose address this is.
std::string way_to_front_page(const std::string& address);

/// What stands around the body of a page.
struct PageFrame {
    std::string title;
    std::string kind = "page";  // the class of its body: "lesson"
    std::string chapter = {};   // "07"; empty: none
};

/// A whole page around `body`, with its style and script inside; `navigation` is repeated at its top and its end.
std::string whole_page(const PageFrame& frame, const std::string& navigation, const std::string& body);

}  // namespace raylab
