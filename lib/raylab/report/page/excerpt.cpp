#include "raylab/report/page/excerpt.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace raylab {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::size_t indentation(const std::string& line) {
    const auto first = line.find_first_not_of(' ');
    return first == std::string::npos ? 0 : first;
}

}  // namespace

Excerpt excerpt(const std::filesystem::path& source, const std::string& begin) {
    const auto lines = lines_of(read_file(source));
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (lines[i].find(begin) != std::string::npos) found.push_back(i);
    if (found.size() != 1)
        throw Error({source.string()}, "exactly one line with '" + begin + "'", std::to_string(found.size()));
    const auto first = found[0], indent = indentation(lines[first]);
    const auto closes = [&](const std::string& line) {
        return indentation(line) == indent && line.size() > indent && line[indent] == '}';
    };
    const auto after = lines.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = std::find_if(after, lines.end(), closes);
    if (end == lines.end())
        throw Error({source.string(), static_cast<int>(first) + 1}, "a closing brace below, at the same indentation",
                    "none");
    const auto last = static_cast<std::size_t>(end - lines.begin());
    if (last - first + 1 > longest_excerpt)
        throw Error({source.string(), static_cast<int>(first) + 1},
                    "at most " + std::to_string(longest_excerpt) + " lines for an excerpt",
                    std::to_string(last - first + 1));
    Excerpt made{.first_line = static_cast<int>(first) + 1, .last_line = static_cast<int>(last) + 1};
    for (auto i = first; i <= last; ++i) made.text += lines[i].substr(std::min(indent, lines[i].size())) + "\n";
    return made;
}

}  // namespace raylab
