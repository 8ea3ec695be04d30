#include "raylab/report/page/page_parts.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/report/page/drawing_size.h"
#include "raylab/report/page/embedded.h"
#include "raylab/report/page/html.h"
#include "raylab/report/page/inline_svg.h"
#include "raylab/report/page/pixel_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>

namespace raylab {

namespace fs = std::filesystem;

namespace {

// Pixels across; a smaller picture is shown enlarged, because its pixels are of interest.
constexpr unsigned small_picture = 200;

struct Size {
    unsigned width, height;
};

// The first chunk of a PNG is its header: width and height are at bytes 16 and 20, big-endian.
std::optional<Size> png_size(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    unsigned char bytes[24];
    if (path.extension() != ".png" || !file.read(reinterpret_cast<char*>(bytes), sizeof bytes)) return std::nullopt;
    const auto number = [&](int at) {
        return unsigned{bytes[at]} << 24 | unsigned{bytes[at + 1]} << 16 | unsigned{bytes[at + 2]} << 8 | bytes[at + 3];
    };
    return Size{number(16), number(20)};
}

// What the page must know of a drawing: its shape before it is loaded, and how large its letters are
// (script/lecture_fit.js).
std::string drawing_attributes(const std::string& svg) {
    const auto size = drawing_size(svg);
    if (!size) return "";
    const auto letter = size->smallest_letter ? fmt::format(" data-label=\"{:.4g}\"", *size->smallest_letter) : "";
    return fmt::format(" width=\"{0:.0f}\" height=\"{1:.0f}\" data-width=\"{0:.6g}\" data-height=\"{1:.6g}\"{2}",
                       size->width, size->height, letter);
}

// A column whose cells all begin like numbers is aligned to the right.
bool is_numeric(const std::vector<std::vector<std::string>>& rows, std::size_t column) {
    return std::ranges::all_of(rows, [&](const auto& row) {
        const auto& cell = row[column];
        const auto first = cell.find_first_not_of("<>~±+- ");
        return first != std::string::npos && std::string("0123456789.").find(cell[first]) != std::string::npos;
    });
}

}  // namespace

bool is_drawing(const std::string& file) { return fs::path(file).extension() == ".svg"; }

std::string picture_html(const fs::path& folder, const std::string& file, const std::string& shows) {
    if (!fs::exists(folder / file))
        throw Error({(folder / file).string()}, "a picture that the page shows", "nothing there");
    std::string size;
    const auto pixels = png_size(folder / file);
    if (pixels)
        size = " width=\"" + std::to_string(pixels->width) + "\" height=\"" + std::to_string(pixels->height) + "\"";
    if (pixels && pixels->width <= small_picture) size += " class=\"small\"";
    if (is_drawing(file)) {
        const auto svg = read_file(folder / file);
        // A script reaches the marks of a drawing only if it is part of the page.
        if (svg.find(" data-visit=") != std::string::npos)
            return "<div class=\"scroll\">" + inline_svg(svg, fs::path(file).stem(), shows) + "</div>";
        size = drawing_attributes(svg);
    }
    const auto values = pixel_values_file(file);
    const auto read_by =
        pixels && fs::exists(folder / values) ? " data-values=\"" + escape_html(values) + "\"" : std::string();
    return "<a href=\"" + escape_html(file) + "\"" + read_by + "><img src=\"" + escape_html(file) +
           "\" loading=\"lazy\" alt=\"" + escape_html(shows) + "\"" + size + "></a>";
}

std::string table_html(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                       const std::string& caption) {
    std::vector<std::string> kinds;
    for (std::size_t i = 0; i < header.size(); ++i) kinds.push_back(is_numeric(rows, i) ? " class=\"data\"" : "");
    std::string html = "<div class=\"scroll wide\" tabindex=\"0\"><table>\n";
    if (!caption.empty()) html += "<caption>" + html_from_markdown_line(caption) + "</caption>\n";
    html += "<thead><tr>";
    for (std::size_t i = 0; i < header.size(); ++i)
        html += "<th scope=\"col\"" + kinds[i] + ">" + html_from_markdown_line(header[i]) + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const auto& row : rows) {
        html += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i)
            html += i == 0 && kinds[i].empty() ? "<th scope=\"row\">" + html_from_markdown_line(row[i]) + "</th>"
                                               : "<td" + kinds[i] + ">" + html_from_markdown_line(row[i]) + "</td>";
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string verdict_chip(std::size_t as_expected, std::size_t total) {
    const bool good = as_expected == total;
    return std::string("<span class=\"chip ") + (good ? "good\">✓ " : "bad\">✗ ") + std::to_string(as_expected) +
           " of " + std::to_string(total) + " failure cases as expected</span>";
}

std::string facts_html(const std::vector<Fact>& facts) {
    std::string html = "<dl class=\"facts\">\n";
    for (const auto& [name, value] : facts)
        html += "<dt>" + escape_html(name) + "</dt><dd>" + escape_html(value) + "</dd>\n";
    return html + "</dl>\n";
}

std::string way_to_front_page(const std::string& address) {
    return "<nav class=\"book\" aria-label=\"Chapters\"><span></span><span><a href=\"" + escape_html(address) +
           "\">Lab book</a></span><span></span></nav>\n";
}

std::string whole_page(const PageFrame& frame, const std::string& navigation, const std::string& body) {
    const auto chapter = frame.chapter.empty() ? "" : " data-chapter=\"" + escape_html(frame.chapter) + "\"";
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
           escape_html(frame.title) + "</title>\n<style>" + page_style() + "</style>\n</head>\n<body class=\"" +
           escape_html(frame.kind) + "\"" + chapter +
           ">\n<a class=\"skip\" href=\"#content\">Skip to the content</a>\n" + navigation + body + navigation +
           "<script>" + page_script() + "</script>\n</body>\n</html>\n";
}

}  // namespace raylab
