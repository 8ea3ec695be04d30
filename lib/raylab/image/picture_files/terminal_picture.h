#pragma once

#include "raylab/image/image.h"

#include <string>
#include <string_view>

// Pictures in a terminal, by what it announces in its environment. (Sixel is announced only in answer to a question,
// which a program that also reads keys cannot ask without taking some of them.)

namespace raylab {

enum class TerminalPictures {
    none,
    half_blocks,  // two pixels a character, in 24-bit colours
    kitty,        // https://sw.kovidgoyal.net/kitty/graphics-protocol/
    iterm         // https://iterm2.com/documentation-images.html
};

/// What the environment says of the terminal; empty: the variable is not set.
struct TerminalEnvironment {
    std::string_view term, term_program, color_term, kitty_window, no_color;
};

/// The best that it announces. A multiplexer (TERM is screen or tmux) passes no pictures on, but colours.
TerminalPictures terminal_pictures(const TerminalEnvironment& environment);

/// That of standard output; none, where it is no terminal.
TerminalPictures terminal_pictures_of_standard_output();

/// The picture as text for such a terminal, this many columns wide at most; none: no text. Half blocks show every n-th
/// pixel's surroundings as their mean.
std::string terminal_picture(const Image& image, TerminalPictures how, int columns);

}  // namespace raylab
