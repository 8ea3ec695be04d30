#pragma once

#include "raylab/base/output_file.h"

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

// Diagrams by libcgraph and libgvc. These are not thread-safe even with a context for each thread, and they end the
// process when memory is exhausted, so each diagram is drawn in a copy of the process.

namespace raylab {

struct DiagramNode {
    std::string label;  // plain text; \n breaks lines; it is escaped here
    std::string tooltip = {};
    std::string shape = "box";  // a name of Graphviz
    std::string fill = "#ffffff";
    std::string style = {};        // "dashed", "bold"; colour is never the only distinction
    double area = 1;               // relative to the default, 1
    std::string line = "#000000";  // colours of the outline and of the text
    std::string text = "#000000";
    double pen = 1;                                                   // of the outline, in points
    double font = 11;                                                 // in points
    enum class Size { around_text, exact } size = Size::around_text;  // around_text: a long text makes it larger
    static constexpr std::size_t no_group = std::numeric_limits<std::size_t>::max();
    std::size_t group = no_group;  // index into Diagram::groups
};

struct DiagramEdge {
    std::size_t from, to;
    std::string label = {};
    std::string color = "#333333";
    std::string style = {};
    double pen = 1;  // in points
};

struct Diagram {
    std::string title;
    std::vector<DiagramNode> nodes;
    std::vector<DiagramEdge> edges;
    enum class Layout { layered, radial } layout = Layout::layered;
    // Titles of the frames around some of the nodes (only for the layered layout)
    std::vector<std::string> groups = {};
    std::string inset = {};  // the bytes of a PNG that is drawn beside the nodes; a .dot file has none
};

/// Writes a diagram in the format of the file's extension: .dot, .svg, .png, .pdf. The file is written whole or not at
/// all; the same diagram gives the same bytes on one machine. It throws an Error where the diagram cannot be drawn, for
/// instance for lack of memory, or not within a minute.
void write_diagram(const Diagram& diagram, const OutputFile& file);

/// Throws an Error where write_diagram() would refuse the name, so that a long computation before it is not wasted.
void check_diagram_name(const std::filesystem::path& path);

}  // namespace raylab
