#include "source_text.h"

#include "directives.h"

#include "raylab/base/file.h"
#include "raylab/base/printable.h"
#include "raylab/base/with_all_replaced.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>

namespace raylab::grading {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t shown_lines = 20;     // the first errors are the true ones
constexpr std::size_t shown_columns = 240;  // of a line; templates can fill pages

bool is_below(const fs::path& file, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

// /usr/include holds other libraries, too, and some of them know how to hit a triangle.
bool is_of_system(const fs::path& file) {
    static const std::array<fs::path, 8> folders{"/usr/lib/gcc",
                                                 "/usr/lib/llvm-16",
                                                 "/usr/include/c++",
                                                 "/usr/include/x86_64-linux-gnu",
                                                 "/usr/include/aarch64-linux-gnu",
                                                 "/usr/include/glm",
                                                 "/usr/include/linux",
                                                 "/usr/include/asm-generic"};
    return file.parent_path() == "/usr/include" ||
           std::ranges::any_of(folders, [&](const auto& folder) { return is_below(file, folder); });
}

}  // namespace

std::string source_text(const fs::path& file) {
    auto text = read_file(file, largest_source);
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
    return with_all_replaced(text, "\r\n", "\n");
}

std::vector<std::string> faults_of_directives(const std::string& text) {
    std::vector<std::string> faults;
    for (const auto& asked : included_names(text)) {
        const bool is_named = asked.size() > 2 && (asked[0] == '"' || asked[0] == '<');
        const auto name = is_named ? asked.substr(1, asked.find_first_of("\">", 1) - 1) : std::string();
        const auto steps = fs::path(name);
        const bool is_source = steps.extension() == ".cpp" || steps.extension() == ".cc" || steps.extension() == ".c";
        if (!is_named || steps.is_absolute() || is_source || std::ranges::find(steps, "..") != steps.end())
            faults.push_back(
                fmt::format("the file includes {}: an answer may include headers only, by the names that its "
                            "stub uses, of the standard library, GLM and the lab's public headers",
                            printable(asked.substr(0, shown_columns))));
    }
    return faults;
}

std::vector<fs::path> included_files(const fs::path& dependencies) {
    std::istringstream words(with_all_replaced(read_file(dependencies), "\\\n", ""));
    std::vector<std::string> names{std::istream_iterator<std::string>(words), {}};
    // "answer.o:", then the file itself, then all that it includes
    return {names.begin() + std::min<std::ptrdiff_t>(2, std::ssize(names)), names.end()};
}

std::vector<std::string> faults_of_includes(const std::vector<fs::path>& included, const fs::path& headers) {
    std::vector<std::string> faults;
    for (const auto& file : included) {
        const auto place = file.lexically_normal();
        if (is_below(place, headers) || is_of_system(place)) continue;
        faults.push_back(fmt::format("the file includes {}, which is no header of the standard library, GLM or this "
                                     "exercise",
                                     printable(file.string())));
        break;  // what that one includes follows
    }
    return faults;
}

std::string shown_messages(const std::string& messages, const fs::path& copy, const fs::path& file) {
    auto text = with_all_replaced(messages, copy.filename().string() + ":", file.lexically_normal().string() + ":");
    text = with_all_replaced(text, copy.parent_path().string() + "/include/", "");
    text = with_all_replaced(text, "./raylab/", "raylab/");  // headers that were compiled before
    std::istringstream lines(printable_lines(text));
    std::string shown;
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        if (count >= shown_lines) continue;
        shown += line.size() > shown_columns ? line.substr(0, shown_columns) + "...\n" : line + "\n";
    }
    if (count > shown_lines) shown += fmt::format("({} more lines)\n", count - shown_lines);
    return shown;
}

bool asks_for_other_headers(const std::string& messages) {
    return messages.find("No such file or directory") != std::string::npos ||
           messages.find("Permission denied") != std::string::npos;
}

}  // namespace raylab::grading
