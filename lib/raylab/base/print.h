#pragma once

#include <string>
#include <string_view>

// Prints on standard output so that no output is lost silently: an Error says why it cannot be written.

namespace raylab {

/// Thrown where the program must end without a message: the reader of its output has gone (a closed pipe), or a program
/// that it ran has printed the reason. run_program() ends silently, with ExitCode::could_not.
struct EndQuietly {};

/// Text for people as standard output shows it: unprintable characters are escaped (see printable_lines()), and signs
/// are coloured where it is a terminal (see painted_signs()).
std::string shown_text(std::string_view text);

/// Prints text for people, of one line or more, as shown_text() has it.
void print_text(std::string_view text);

/// Prints data unchanged.
void print_data(std::string_view bytes);

/// Prints text for people on standard error, escaped in the same way; it is lost where that cannot be written.
void print_note(std::string_view text);

/// Passes on what has been printed so far; run_program() calls it at the end.
void flush_standard_output();

}  // namespace raylab
