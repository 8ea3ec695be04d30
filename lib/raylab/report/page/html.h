#pragma once

#include <string>
#include <string_view>

namespace raylab {

/// Text as HTML shows it, in an element or in a quoted attribute.
std::string escape_html(std::string_view text);

/// A small Markdown as HTML: paragraphs, lists ("- " and "1. "), ```fenced code```, `code`, *emphasis*, **strong**,
/// [links](to pages, pictures or https). Everything else is text: no HTML passes through.
std::string html_from_markdown(std::string_view markdown);

/// The same without paragraphs, for a caption or a cell.
std::string html_from_markdown_line(std::string_view markdown);

/// A name for an anchor: "Speed & accuracy" becomes "speed-accuracy".
std::string anchor_name(std::string_view text);

}  // namespace raylab
