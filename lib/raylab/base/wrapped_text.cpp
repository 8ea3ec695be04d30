#include "raylab/base/wrapped_text.h"

#include <algorithm>
#include <sstream>

namespace raylab {

std::size_t length_shown(const std::string& text) {
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
    return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, continues));
}

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
    std::vector<std::string> lines = {""};
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        const bool fits = lines.back().empty() || length_shown(lines.back()) + 1 + length_shown(word) <= width;
        if (!fits) lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
    }
    return lines;
}

}  // namespace raylab
