#include "raylab/base/painted_signs.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace raylab {

namespace {

struct Paint {
    std::string_view sign, begin;  // the sign, and the terminal's sequence for its colour (ECMA-48, SGR)
};

constexpr Paint paints[] = {{"✓", "\033[32m"}, {"✗", "\033[31m"}, {"‼", "\033[1;97;41m"}};
constexpr std::string_view end_of_paint = "\033[0m";

}  // namespace

std::string painted_signs(std::string_view text) {
    std::string painted;
    while (!text.empty()) {
        const auto* paint = std::ranges::find_if(paints, [&](const Paint& one) { return text.starts_with(one.sign); });
        if (paint == std::end(paints)) {
            painted += text[0];
            text.remove_prefix(1);
            continue;
        }
        const auto length = std::min({text.find("  "), text.find('\n'), text.size()});
        painted.append(paint->begin).append(text.substr(0, length)).append(end_of_paint);
        text.remove_prefix(length);
    }
    return painted;
}

bool standard_output_shows_colors() {
    const auto value_of = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string_view(value ? value : "");
    };
    return isatty(STDOUT_FILENO) == 1 && value_of("NO_COLOR").empty() && value_of("TERM") != "dumb";
}

}  // namespace raylab
