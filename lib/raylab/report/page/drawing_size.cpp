#include "raylab/report/page/drawing_size.h"

#include <algorithm>
#include <regex>
#include <string>

namespace raylab {

namespace {

// Graphviz and the lab's own drawings give each text its size, gnuplot each group of texts. (Sub- and superscripts,
// which are smaller, are tspans.)
std::optional<double> smallest_letter_of(const std::string& svg) {
    static const std::regex pattern(R"re(<(?:text|g)\b[^>]*\bfont-size="([0-9.]+))re");
    std::optional<double> smallest;
    for (auto found = std::sregex_iterator(svg.begin(), svg.end(), pattern); found != std::sregex_iterator(); ++found) {
        const double size = std::stod((*found)[1]);
        smallest = std::min(smallest.value_or(size), size);
    }
    return smallest;
}

}  // namespace

std::optional<DrawingSize> drawing_size(std::string_view svg) {
    static const std::regex pattern(R"re(<svg\b[^>]*\bviewBox="[-0-9.]+ [-0-9.]+ ([0-9.]+) ([0-9.]+)")re");
    const std::string text(svg);
    std::smatch box;
    if (!std::regex_search(text, box, pattern)) return std::nullopt;
    return DrawingSize{std::stod(box[1]), std::stod(box[2]), smallest_letter_of(text)};
}

}  // namespace raylab
