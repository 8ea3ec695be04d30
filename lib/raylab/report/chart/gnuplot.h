#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// Only this file knows how gnuplot is called.

namespace raylab {

/// The path of gnuplot; empty where there is none.
std::filesystem::path gnuplot_program();

/// A text as a literal of gnuplot's script: in single quotes, where nothing is substituted, on one line.
std::string gnuplot_text(std::string_view text);

/// A literal whose text is bold, for a label with `enhanced`.
std::string gnuplot_bold_text(std::string_view text);

/// The shortest text of a number: "0.25".
std::string gnuplot_number(double value);

/// A gnuplot script that draws on a canvas of pixels.
struct GnuplotDrawing {
    int width, height;
    // Without terminal and output; a point size multiplied by `marker` looks equally large in every format.
    std::string script;
    double timeout = 60;  // seconds for each format
};

/// Writes folder/name.gp, and draws .svg and, where this gnuplot can, .png (with twice the pixels). Returns the files.
/// Without gnuplot only the script is written, with a note on stderr. It throws an Error where gnuplot refuses the
/// script or does not end.
std::vector<std::filesystem::path> draw(const GnuplotDrawing& drawing, const std::filesystem::path& folder,
                                        const std::string& name);

}  // namespace raylab
