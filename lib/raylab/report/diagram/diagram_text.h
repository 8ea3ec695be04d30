#pragma once

#include <string>
#include <string_view>

namespace raylab {

/// Escapes plain text for a Graphviz label: no \N, no &amp;, no control characters; a line break stays one.
std::string diagram_text(std::string_view text);

/// Replaces the dates of a PDF by a constant of the same length, so that the same drawing gives the same bytes.
std::string without_date(std::string pdf);

}  // namespace raylab
