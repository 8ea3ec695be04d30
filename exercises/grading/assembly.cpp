#include "assembly.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

namespace raylab::grading {

namespace {

// GCC and clang write #APP before what stands in asm(). The name of a section or a symbol could hold directives, too,
// and macros could put one together from harmless parts.
bool is_foreign(const std::string& line) {
    constexpr std::array<std::string_view, 6> directives{".incbin", ".include", ".macro", ".irp", ".rept", ".altmacro"};
    return line.starts_with("#APP") || std::ranges::any_of(directives, [&](std::string_view directive) {
               return line.find(directive) != std::string::npos;
           });
}

// Whether the line is a text of the program's own and nothing else: .string "...", .ascii "..."
bool is_text(std::string_view line) {
    const auto begin = line.find('"');
    const auto directive = line.substr(0, begin);
    if (begin == line.npos || (directive != "\t.string\t" && directive != "\t.ascii\t")) return false;
    auto at = begin + 1;
    while (at < line.size() && line[at] != '"') at += line[at] == '\\' ? 2 : 1;
    return at + 1 == line.size();
}

}  // namespace

std::vector<std::string> faults_of_assembly(const std::string& assembly) {
    std::istringstream lines(assembly);
    for (std::string line; std::getline(lines, line);)
        if (is_foreign(line) && !is_text(line))
            return {"the file contains assembly (asm), by which a program could take in other files: an answer is C++"};
    return {};
}

}  // namespace raylab::grading
