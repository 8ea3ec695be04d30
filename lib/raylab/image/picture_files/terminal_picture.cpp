#include "raylab/image/picture_files/terminal_picture.h"

#include "raylab/base/base64.h"
#include "raylab/image/color.h"
#include "raylab/image/picture_files/files.h"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace raylab {

namespace {

// The mean of the pixels in [left, right) x [top, bottom).
Pixel mean_of(const Image& image, int left, int right, int top, int bottom) {
    Pixel sum{};
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            const Pixel& pixel = image.at(x, y);
            sum = {sum.r + pixel.r, sum.g + pixel.g, sum.b + pixel.b};
        }
    const auto count = static_cast<float>((right - left) * (bottom - top));
    return {sum.r / count, sum.g / count, sum.b / count};
}

// The upper half of a character is its foreground, the lower one its background (ECMA-48, SGR 38 and 48).
std::string in_half_blocks(const Image& image, int columns) {
    const int step = std::max(1, (image.width() + columns - 1) / columns);
    const auto color = [&](int x, int y) {
        const int top = std::min(y, image.height() - 1);
        const Pixel p = mean_of(image, x, std::min(x + step, image.width()), top, std::min(top + step, image.height()));
        return fmt::format("2;{};{};{}m", srgb_byte(p.r), srgb_byte(p.g), srgb_byte(p.b));
    };
    std::string text;
    for (int y = 0; y < image.height(); y += 2 * step) {
        for (int x = 0; x < image.width(); x += step)
            text += "\033[38;" + color(x, y) + "\033[48;" + color(x, y + step) + "▀";
        text += "\033[0m\n";
    }
    return text;
}

// A PNG file in pieces of at most 4096 bytes, of which all but the last say that more follow.
std::string for_kitty(const Image& image, int columns) {
    constexpr std::size_t largest = 4096;
    const auto coded = base64(png_bytes(image));
    std::string text;
    for (std::size_t at = 0; at < coded.size(); at += largest)
        text += fmt::format("\033_G{}m={};{}\033\\", at == 0 ? fmt::format("a=T,f=100,q=2,c={},", columns) : "",
                            at + largest < coded.size() ? 1 : 0, coded.substr(at, largest));
    return text + "\n";
}

std::string for_iterm(const Image& image, int columns) {
    const auto bytes = png_bytes(image);
    return fmt::format("\033]1337;File=inline=1;size={};width={}:{}\a\n", bytes.size(), columns, base64(bytes));
}

std::string_view value_of(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

}  // namespace

TerminalPictures terminal_pictures(const TerminalEnvironment& environment) {
    const auto& [term, program, colors, kitty_window, no_color] = environment;
    if (!no_color.empty() || term.empty() || term == "dumb") return TerminalPictures::none;
    if (!term.starts_with("screen") && !term.starts_with("tmux")) {
        if (term == "xterm-kitty" || !kitty_window.empty() || program == "ghostty") return TerminalPictures::kitty;
        if (program == "iTerm.app" || program == "WezTerm") return TerminalPictures::iterm;
    }
    return colors == "truecolor" || colors == "24bit" ? TerminalPictures::half_blocks : TerminalPictures::none;
}

TerminalPictures terminal_pictures_of_standard_output() {
    if (isatty(STDOUT_FILENO) != 1) return TerminalPictures::none;
    return terminal_pictures({.term = value_of("TERM"),
                              .term_program = value_of("TERM_PROGRAM"),
                              .color_term = value_of("COLORTERM"),
                              .kitty_window = value_of("KITTY_WINDOW_ID"),
                              .no_color = value_of("NO_COLOR")});
}

std::string terminal_picture(const Image& image, TerminalPictures how, int columns) {
    switch (how) {
        case TerminalPictures::none:
            return {};
        case TerminalPictures::half_blocks:
            return in_half_blocks(image, columns);
        case TerminalPictures::kitty:
            return for_kitty(image, std::min(columns, image.width()));
        case TerminalPictures::iterm:
            return for_iterm(image, std::min(columns, image.width()));
    }
    return {};
}

}  // namespace raylab
