#pragma once

#include "raylab/base/output_file.h"

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

// Diagrams through libcgraph and libgvc, which are not thread-safe even with a context per thread, and which end the
// process where memory is short: each is drawn in a copy of the process.

namespace raylab {

struct DiagramNode {
    std::string label;  // plain text; \n breaks lines; escaped here
    std::string tooltip = {};
    std::string shape = "box";  // Graphviz's names
    std::string fill = "#ffffff";
    std::string style = {};        // "dashed", "bold"; colour is never the only sign
    double area = 1;               // relative to 1
    std::string line = "#000000";  // colours of the outline and of the text
    std::string text = "#000000";
    double pen = 1;                                                   // points, of the outline
    double font = 11;                                                 // points
    enum class Size { around_text, exact } size = Size::around_text;  // whether text may make it larger
    static constexpr std::size_t no_group = std::numeric_limits<std::size_t>::max();
    std::size_t group = no_group;  // index into Diagram::groups
};

struct DiagramEdge {
    std::size_t from, to;
    std::string label = {};
    std::string color = "#333333";
    std::string style = {};
    double pen = 1;  // points
};

struct Diagram {
    std::string title;
    std::vector<DiagramNode> nodes;
    std::vector<DiagramEdge> edges;
    enum class Layout { layered, radial } layout = Layout::layered;
    std::vector<std::string> groups = {};  // titles of the frames around some of the nodes (layered only)
};

/// By extension: .dot, .svg, .png, .pdf. Whole or not at all; the same bytes for the same diagram on one machine.
/// Error where it cannot be drawn, for want of memory say, or not within a minute.
void write_diagram(const Diagram& diagram, const OutputFile& file);

/// Error where write_diagram() would refuse the name, for whoever works long before a diagram is written.
void check_diagram_name(const std::filesystem::path& path);

}  // namespace raylab
