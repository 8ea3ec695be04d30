#include "raylab/report/diagram/diagram.h"

#include "raylab/base/base64.h"
#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/printable.h"
#include "raylab/base/process.h"
#include "raylab/base/temporary.h"
#include "raylab/base/with_all_replaced.h"
#include "raylab/report/diagram/diagram_text.h"

#include <fmt/format.h>
#include <graphviz/gvc.h>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>

namespace raylab {

namespace {

// The messages of Graphviz. It reports them only to a plain function.
std::string& complaints() {
    static std::string text;
    return text;
}

int keep_complaint(char* message) {
    complaints() += message;
    return 0;
}

// Graphviz's C interface takes char* for text that it only reads.
char* c(const char* text) { return const_cast<char*>(text); }
char* c(const std::string& text) { return const_cast<char*>(text.c_str()); }

using Graph = std::unique_ptr<Agraph_t, decltype([](Agraph_t* graph) { agclose(graph); })>;

/// A layout of a graph; it must be freed before the graph is.
class Layout {
public:
    Layout(GVC_t* context, Agraph_t* graph, const char* engine) : context_(context), graph_(graph) {
        if (gvLayout(context, graph, engine) != 0) throw Error(on_one_line("no layout: " + complaints()));
    }
    ~Layout() { gvFreeLayout(context_, graph_); }
    Layout(const Layout&) = delete;
    Layout& operator=(const Layout&) = delete;

private:
    GVC_t* context_;
    Agraph_t* graph_;
};

void set(void* object, const char* name, const std::string& value) {
    if (!value.empty()) agsafeset(object, c(name), c(value), c(""));
}

const std::string font = "DejaVu Sans,Helvetica,Arial,sans-serif";

// An attribute with Graphviz's default value is not written.
template <class Value>
void set_unless(const Value& usual, void* object, const char* name, const Value& value) {
    if (value != usual) set(object, name, fmt::format("{}", value));
}

void set_style(Agraph_t* graph, const Diagram& diagram) {
    set(graph, "label", diagram_text(diagram.title));
    set(graph, "labelloc", "t");
    set(graph, "fontname", font);
    set(graph, "fontsize", "15");
    set(graph, "nodesep", "0.3");
    set(graph, "ranksep", diagram.layout == Diagram::Layout::layered ? "0.45" : "1.0");
    set(graph, "pad", "0.15");
    for (const int kind : {AGNODE, AGEDGE}) agattr(graph, kind, c("fontname"), c(font));
    agattr(graph, AGNODE, c("fontsize"), c("11"));
    agattr(graph, AGEDGE, c("fontsize"), c("13"));  // of as few words, which are read beside a line
    agattr(graph, AGNODE, c("margin"), c("0.12,0.07"));
    agattr(graph, AGEDGE, c("arrowsize"), c("0.7"));
}

Agnode_t* add_node(Agraph_t* graph, std::size_t number, const DiagramNode& node) {
    assert(node.shape.find("record") == std::string::npos);  // the labels of record shapes have a grammar of their own
    auto* added = agnode(graph, c("n" + std::to_string(number)), 1);
    const double side = std::sqrt(node.area);
    set(added, "label", node.label.empty() ? " " : diagram_text(node.label));
    set(added, "tooltip", diagram_text(node.tooltip.empty() ? node.label : node.tooltip));
    set(added, "shape", node.shape);
    set(added, "style", node.style.empty() ? "filled" : "filled," + node.style);
    set(added, "fillcolor", node.fill);
    set(added, "width", std::to_string(0.75 * side));  // the smallest box of Graphviz, in inches
    set(added, "height", std::to_string(0.5 * side));
    set_unless(DiagramNode{}.line, added, "color", node.line);
    set_unless(DiagramNode{}.text, added, "fontcolor", node.text);
    set_unless(DiagramNode{}.pen, added, "penwidth", node.pen);
    set_unless(DiagramNode{}.font, added, "fontsize", node.font);
    if (node.size == DiagramNode::Size::exact) set(added, "fixedsize", "true");
    return added;
}

void add_edge(Agraph_t* graph, const std::vector<Agnode_t*>& nodes, const DiagramEdge& edge) {
    assert(edge.from < nodes.size() && edge.to < nodes.size());
    auto* added = agedge(graph, nodes[edge.from], nodes[edge.to], nullptr, 1);
    set(added, "label", edge.label.empty() ? "" : diagram_text("  " + edge.label));
    set(added, "color", edge.color);
    set(added, "style", edge.style);
    set(added, "fontcolor", edge.label.empty() ? "" : edge.color);
    set_unless(DiagramEdge{}.pen, added, "penwidth", edge.pen);
}

// Draws a frame, with a title, around the nodes of each group.
void add_groups(Agraph_t* graph, const std::vector<Agnode_t*>& nodes, const Diagram& diagram) {
    for (std::size_t i = 0; i < diagram.groups.size(); ++i) {
        auto* frame = agsubg(graph, c("cluster" + std::to_string(i)), 1);
        set(frame, "label", diagram_text(diagram.groups[i]));
        set(frame, "fontname", font);
        set(frame, "color", "#999999");
        set(frame, "style", "rounded");
        set(frame, "margin", "14");
        for (std::size_t n = 0; n < nodes.size(); ++n)
            if (diagram.nodes[n].group == i) agsubnode(frame, nodes[n], 1);
    }
}

Graph graph_of(const Diagram& diagram) {
    Graph graph(agopen(c("diagram"), Agdirected, nullptr));
    set_style(graph.get(), diagram);
    std::vector<Agnode_t*> nodes;
    for (std::size_t i = 0; i < diagram.nodes.size(); ++i) nodes.push_back(add_node(graph.get(), i, diagram.nodes[i]));
    add_groups(graph.get(), nodes, diagram);
    for (const auto& edge : diagram.edges) add_edge(graph.get(), nodes, edge);
    return graph;
}

// A node of its own, which the layout puts beside the roots.
void add_inset(Agraph_t* graph, const std::string& file) {
    auto* added = agnode(graph, c("inset"), 1);
    set(added, "label", " ");
    set(added, "shape", "none");
    set(added, "margin", "0");
    set(added, "image", file);
}

// An SVG that holds the inset itself instead of its file's name.
std::string with_inset_inside(const std::string& svg, const std::string& file, const std::string& png) {
    return with_all_replaced(svg, file, "data:image/png;base64," + base64(png));
}

// Graphviz reads an inset from a file only. Where that cannot be written, the message names the diagram.
std::string written_inset(const std::string& png, const ScratchFolder& scratch, const OutputFile& diagram) {
    const auto file = scratch.path() / "inset.png";
    try {
        write_file(file, png);
    } catch (const Error&) {
        throw Error({diagram.path.string()}, "a temporary file for the picture beside its nodes",
                    "none can be written");
    }
    return file.string();
}

std::string dot_text(Agraph_t* graph) {
    char* bytes = nullptr;
    std::size_t size = 0;
    std::FILE* memory = open_memstream(&bytes, &size);
    if (!memory) throw std::bad_alloc();
    agwrite(graph, memory);
    std::fclose(memory);
    const std::string text(bytes, size);
    std::free(bytes);
    return text;
}

std::string rendered(Agraph_t* graph, const Diagram& diagram, const std::string& inset, const std::string& format) {
    if (!inset.empty()) add_inset(graph, inset);
    if (format == "png") set(graph, "dpi", "160");  // the resolution of a projector; vector formats need none
    // Never freed, because the Pango plugin of Graphviz 2.42.2 keeps a pointer into its fonts.
    GVC_t* const context = gvContext();
    const Layout layout(context, graph, diagram.layout == Diagram::Layout::layered ? "dot" : "twopi");
    char* bytes = nullptr;
    unsigned size = 0;
    const bool failed = gvRenderData(context, graph, format.c_str(), &bytes, &size) != 0;
    // The picture would then be different.
    const bool without_a_plugin = complaints().find("Could not load") != std::string::npos;
    if (failed || without_a_plugin) throw Error(on_one_line("no picture: " + complaints()));
    const std::string drawn(bytes, size);
    gvFreeRenderData(bytes);
    if (format == "svg" && !inset.empty()) return with_inset_inside(drawn, inset, diagram.inset);
    return format == "pdf" ? without_date(drawn) : drawn;
}

}  // namespace

void check_diagram_name(const std::filesystem::path& path) {
    const auto extension = path.extension().string();
    if (extension != ".dot" && extension != ".svg" && extension != ".png" && extension != ".pdf")
        throw Error({path.string()}, "a diagram to end in .dot, .svg, .png or .pdf", "'" + extension + "'");
}

void write_diagram(const Diagram& diagram, const OutputFile& file) {
    check_diagram_name(file.path);
    const auto extension = file.path.extension().string();
    const ScratchFolder scratch;
    const std::string inset =
        diagram.inset.empty() || extension == ".dot" ? "" : written_inset(diagram.inset, scratch, file);
    const auto drawn = run_in_copy(
        [&] {
            agseterrf(keep_complaint);
            const Graph graph = graph_of(diagram);
            return extension == ".dot" ? dot_text(graph.get())
                                       : rendered(graph.get(), diagram, inset, extension.substr(1));
        },
        {.timeout = 60, .output_limit = std::size_t{1} << 30});
    if (!drawn.succeeded())
        throw Error({file.path.string()}, "memory and time enough for a diagram", failure_of("its drawing", drawn));
    write_file(file, drawn.output);
}

}  // namespace raylab
