#include "raylab/report/page/inline_svg.h"

#include "raylab/report/page/html.h"

namespace raylab {

namespace {

void replace_all(std::string& text, const std::string& found, const std::string& better) {
    for (auto at = text.find(found); at != std::string::npos; at = text.find(found, at + better.size()))
        text.replace(at, found.size(), better);
}

}  // namespace

std::string inline_svg(std::string svg, const std::string& name, const std::string& description) {
    const auto own = escape_html(name);
    replace_all(svg, "id=\"frame\"", "id=\"frame-" + own + "\"");
    replace_all(svg, "url(#frame)", "url(#frame-" + own + ")");
    const auto width = svg.find(" width=\"") + 8;
    const auto pixels = svg.substr(width, svg.find('"', width) - width);
    svg.insert(4, " role=\"img\" aria-label=\"" + escape_html(description) + "\" style=\"--drawn: " + pixels + "px\"");
    return svg;
}

}  // namespace raylab
