#pragma once

#include <string_view>

// Printing on standard output, none of which is lost silently: Error says why it cannot be written.

namespace raylab {

/// Thrown where the program cannot go on and nobody needs to be told: whoever read its output has gone (a closed pipe),
/// or a program it ran has said why. run_program() ends quietly, with ExitCode::could_not.
struct EndQuietly {};

/// Text for people, of one line or more; what is not printable in it is shown escaped (see printable_lines()).
void print_text(std::string_view text);

/// Data, byte by byte.
void print_data(std::string_view bytes);

/// Text for people beside the output: on standard error, in the same way, but lost where that cannot be written.
void print_note(std::string_view text);

/// Hands on what has been printed so far. run_program() does in the end.
void flush_standard_output();

}  // namespace raylab
