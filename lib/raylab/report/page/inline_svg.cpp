#include "raylab/report/page/inline_svg.h"

#include "raylab/base/with_all_replaced.h"
#include "raylab/report/page/html.h"

namespace raylab {

std::string inline_svg(std::string svg, const std::string& name, const std::string& description) {
    const auto own = escape_html(name);
    svg = with_all_replaced(svg, "id=\"frame\"", "id=\"frame-" + own + "\"");
    svg = with_all_replaced(svg, "url(#frame)", "url(#frame-" + own + ")");
    const auto width = svg.find(" width=\"") + 8;
    const auto pixels = svg.substr(width, svg.find('"', width) - width);
    svg.insert(4, " role=\"img\" aria-label=\"" + escape_html(description) + "\" style=\"--drawn: " + pixels + "px\"");
    return svg;
}

}  // namespace raylab
