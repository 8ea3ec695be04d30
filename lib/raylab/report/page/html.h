#pragma once

#include <string>
#include <string_view>

namespace raylab {

/// Escapes text for HTML, for an element or a quoted attribute.
std::string escape_html(std::string_view text);

/// Converts Markdown of any origin to HTML, by cmark-gfm. HTML in it is shown as text, and links go to pages, pictures
/// or https only.
std::string html_from_markdown(std::string_view markdown);

/// Converts Markdown without paragraphs, for a caption or a table cell, with $formulas$.
std::string html_from_markdown_line(std::string_view markdown);

/// The name of an anchor: "Speed & accuracy" becomes "speed-accuracy".
std::string anchor_name(std::string_view text);

}  // namespace raylab
