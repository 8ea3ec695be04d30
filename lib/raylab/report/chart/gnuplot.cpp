#include "raylab/report/chart/gnuplot.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/print.h"
#include "raylab/base/process.h"
#include "raylab/base/with_all_replaced.h"

#include <fmt/format.h>

namespace raylab {

namespace fs = std::filesystem;

namespace {

constexpr int font_size = 14;

// Text is "enhanced", so that words can be bold; all other text is marked noenhanced.
std::string terminal(const std::string& format, const GnuplotDrawing& drawing) {
    if (format == "svg")
        return fmt::format("set terminal svg size {},{} enhanced font 'DejaVu Sans,{}' background '#ffffff'\nmarker "
                           "= 0.66\n",
                           drawing.width, drawing.height, font_size);
    return fmt::format("set terminal pngcairo size {},{} enhanced font 'DejaVu Sans,{}' fontscale 1.5 linewidth 2 "
                       "pointscale 2\nmarker = 1\n",
                       // Gnuplot's points are 4/3 of SVG's, so a factor of 1.5 doubles the size.
                       2 * drawing.width, 2 * drawing.height, font_size);
}

// Gnuplot's message without the copy of the script's line that comes first: "line 7: undefined variable: x".
std::string complaint(const std::string& errors) {
    const auto line = errors.find("line ");
    return line == std::string::npos ? errors : errors.substr(line);
}

// Gnuplot writes the drawing to its standard output, so that its messages do not contain names of our files.
std::string drawn(const fs::path& gnuplot, const std::string& script, double timeout, const fs::path& subject) {
    auto result = run_process(gnuplot, {"-"}, {.input = script, .timeout = timeout});
    if (result.succeeded()) return result.output;
    result.errors = complaint(result.errors);
    throw Error({subject.string()}, "a picture", failure_of("gnuplot", result));
}

// The SVG falls back from DejaVu Sans to Verdana, which has the same widths. Squares and diamonds get about the area of
// the other markers.
std::string improved(std::string svg) {
    svg = with_all_replaced(svg, "font-family=\"DejaVu Sans\"",
                            "font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\"");
    svg = with_all_replaced(svg, "x='-1' y='-1' width='2' height='2'/>",
                            "x='-0.85' y='-0.85' width='1.7' height='1.7'/>");
    svg = with_all_replaced(svg, "stroke-width='0.190'", "stroke-width='0.3'");  // hollow markers as bold as the lines
    return svg;
}

bool can_draw_png(const fs::path& gnuplot) {
    return run_process(gnuplot, {"-e", "set terminal pngcairo"}, {.timeout = 20}).succeeded();
}

}  // namespace

fs::path gnuplot_program() { return find_program("gnuplot"); }

std::string gnuplot_text(std::string_view text) {
    std::string quoted = "'";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '\'')
            quoted += "''";
        else
            quoted += code < 0x20 || code == 0x7f ? ' ' : c;
    }
    return quoted + "'";
}

std::string gnuplot_bold_text(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (std::string_view("\\{}_^@&~").find(c) != std::string_view::npos) escaped += '\\';
        escaped += c;
    }
    return gnuplot_text("{/:Bold " + escaped + "}");
}

std::string gnuplot_number(double value) { return fmt::format("{}", value); }

std::vector<fs::path> draw(const GnuplotDrawing& drawing, const fs::path& folder, const std::string& name) {
    const auto path = [&](const char* extension) { return folder / (name + extension); };
    const auto script = "# gnuplot " + name + ".gp draws " + name + ".svg.\nset encoding utf8\n";
    write_file(path(".gp"),
               script + terminal("svg", drawing) + "set output " + gnuplot_text(name + ".svg") + "\n" + drawing.script);
    std::vector<fs::path> files = {path(".gp")};
    const auto gnuplot = gnuplot_program();
    if (gnuplot.empty()) {
        print_note("raylab: no gnuplot here, so no picture of " + name + ": the data alone\n");
        return files;
    }
    const auto draw_as = [&](const std::string& format, const fs::path& file) {
        auto bytes = drawn(gnuplot, script + terminal(format, drawing) + drawing.script, drawing.timeout, file);
        write_file(file, format == "svg" ? improved(std::move(bytes)) : bytes);
        files.push_back(file);
    };
    draw_as("svg", path(".svg"));
    if (can_draw_png(gnuplot)) draw_as("png", path(".png"));
    return files;
}

}  // namespace raylab
