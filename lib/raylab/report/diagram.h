#pragma once

#include <filesystem>
#include <string>
#include <vector>

// Diagrams through libcgraph and libgvc, which are not thread-safe even with a context per thread: one mutex inside.

namespace raylab {

struct DiagramNode {
    std::string label;     // plain text; \n breaks lines; escaped here
    std::string tooltip = {};
    std::string shape = "box";      // Graphviz's names
    std::string fill = "#ffffff";
    std::string style = {};         // "dashed", "bold"; colour is never the only sign
    double area = 1;                // relative to 1
};

struct DiagramEdge {
    std::size_t from, to;
    std::string label = {};
    std::string color = "#333333";
    std::string style = {};
};

struct Diagram {
    std::string title;
    std::vector<DiagramNode> nodes;
    std::vector<DiagramEdge> edges;
    enum class Layout { layered, radial } layout = Layout::layered;
};

/// By extension: .dot, .svg, .png, .pdf. Whole or not at all; the same bytes for the same diagram on one machine.
void write_diagram(const Diagram& diagram, const std::filesystem::path& path);

}  // namespace raylab
