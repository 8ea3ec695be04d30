#pragma once

#include <string>
#include <string_view>

namespace raylab {

/// Plain text as a Graphviz label shows it: no \N, no &amp;, no control characters; a line break stays one.
std::string diagram_text(std::string_view text);

/// A PDF whose dates are a constant of the same length, so that the same drawing is the same bytes.
std::string without_date(std::string pdf);

}  // namespace raylab
