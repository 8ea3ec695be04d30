#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// The only file that knows how gnuplot is called.

namespace raylab {

/// Where gnuplot is; empty: nowhere.
std::filesystem::path gnuplot_program();

/// A text as gnuplot's script has it: in single quotes, where nothing is substituted, on one line.
std::string gnuplot_text(std::string_view text);

/// The same in bold, for a label with `enhanced`.
std::string gnuplot_bold_text(std::string_view text);

/// "0.25", the shortest text of a number.
std::string gnuplot_number(double value);

/// A drawing: what is drawn, on a canvas of pixels.
struct GnuplotDrawing {
    int width, height;
    std::string script;  // without terminal and output; a point's size times `marker` is as large in every format
    double timeout = 60;  // seconds for each format
};

/// Writes folder/name.gp, and draws .svg and, where this gnuplot can, .png (twice the pixels). Returns the files.
/// Without gnuplot: the script alone, and a note on stderr. Error where gnuplot refuses the script or does not end.
std::vector<std::filesystem::path> draw(const GnuplotDrawing& drawing, const std::filesystem::path& folder,
                                        const std::string& name);

}  // namespace raylab
