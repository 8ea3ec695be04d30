#include "raylab/base/print.h"

#include "raylab/base/error.h"
#include "raylab/base/painted_signs.h"
#include "raylab/base/printable.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace raylab {

namespace {

[[noreturn]] void throw_lost(int problem) {
    if (problem == EPIPE) throw EndQuietly{};
    throw Error({"standard output"}, "a place that can be written", std::strerror(problem));
}

}  // namespace

std::string shown_text(std::string_view text) {
    const auto shown = printable_lines(text);
    return standard_output_shows_colors() ? painted_signs(shown) : shown;
}

void print_text(std::string_view text) { print_data(shown_text(text)); }

void print_data(std::string_view bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size()) throw_lost(errno);
}

void print_note(std::string_view text) { std::fputs(printable_lines(text).c_str(), stderr); }

void flush_standard_output() {
    if (std::fflush(stdout) != 0) throw_lost(errno);
}

}  // namespace raylab
