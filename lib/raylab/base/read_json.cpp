#include "raylab/base/read_json.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace raylab {

using nlohmann::ordered_json;

namespace {

Place place_of(std::string_view text, std::size_t byte, const std::string& source) {
    const auto before = text.substr(0, byte);
    return {source, 1 + static_cast<int>(std::ranges::count(before, '\n')), "byte " + std::to_string(before.size())};
}

// Error where brackets outside of strings nest too deep. Whether they match is the parser's business.
void check_depth(std::string_view text, const std::string& source) {
    std::size_t depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string && c == '\\') ++i;
        if (c == '"') in_string = !in_string;
        if (in_string) continue;
        if ((c == '[' || c == '{') && ++depth > deepest_json)
            throw Error(place_of(text, i, source),
                        "arrays and objects nested at most " + std::to_string(deepest_json) + " deep", "more");
        if ((c == ']' || c == '}') && depth > 0) --depth;
    }
}

// What nlohmann says behind "[json.exception.parse_error.101] parse error at line 1, column 2: ", which may quote the
// whole text.
std::string reason(const ordered_json::exception& problem) {
    constexpr std::size_t longest = 120;
    const std::string said = problem.what();
    const auto colon = said.find(": ");
    const auto why = colon == said.npos ? said : said.substr(colon + 2);
    return why.size() > longest ? why.substr(0, longest) + "..." : why;
}

}  // namespace

ordered_json json_from_text(std::string_view text, const std::string& source) {
    check_depth(text, source);
    try {
        return ordered_json::parse(text);
    } catch (const ordered_json::parse_error& problem) {
        throw Error(place_of(text, problem.byte, source), "JSON", reason(problem));
    } catch (const ordered_json::exception& problem) {
        throw Error({source}, "JSON whose numbers doubles can hold", reason(problem));
    }
}

ordered_json read_json(const std::filesystem::path& path, std::size_t limit) {
    return json_from_text(read_file(path, limit), path.string());
}

}  // namespace raylab
