#include "scene_graph.h"

#include <map>
#include <set>
#include <sstream>

namespace raylab::transforms {

namespace {

// Splits "family[0]/toy[1]/sphere 0" into its parts.
std::vector<std::string> parts_of(const std::string& path) {
    std::vector<std::string> parts;
    std::istringstream stream(path);
    for (std::string part; std::getline(stream, part, '/');) parts.push_back(part);
    return parts;
}

// "toy[1]" is an instance of the group "toy".
std::string group_of(const std::string& part) { return part.substr(0, part.find('[')); }

class Graph {
public:
    explicit Graph(std::string title) {
        diagram_.title = std::move(title);
        nodes_["scene"] = add({.label = "scene", .shape = "ellipse", .fill = "#ffffff", .style = "bold"});
    }

    void add_path(const std::vector<std::string>& parts) {
        std::string parent = "scene";
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
            const auto group = group_of(parts[i]);
            connect(parent, group, parts[i],
                    {.label = group, .shape = "box", .fill = "#e6f1fa", .style = "filled,rounded"});
            parent = group;
        }
        const auto leaf = parent + "/" + parts.back();
        connect(parent, leaf, parts.back(),
                {.label = parts.back(), .shape = "box", .fill = "#fdf3d9", .style = "filled"});
    }

    Diagram diagram() const { return diagram_; }

private:
    std::size_t add(const DiagramNode& node) {
        diagram_.nodes.push_back(node);
        return diagram_.nodes.size() - 1;
    }

    // Draws an arrow for each instance of a group, once however many objects have it in their paths.
    void connect(const std::string& parent, const std::string& child, const std::string& placing,
                 const DiagramNode& node) {
        if (!nodes_.contains(child)) nodes_[child] = add(node);
        if (!placings_.insert(parent + ">" + placing).second) return;
        diagram_.edges.push_back({.from = nodes_[parent], .to = nodes_[child]});
    }

    Diagram diagram_;
    std::map<std::string, std::size_t> nodes_;
    std::set<std::string> placings_;
};

}  // namespace

Diagram scene_graph(const Scene& scene) {
    Graph graph("What is stored, and how often it is placed");
    for (const auto& object : scene.objects) graph.add_path(parts_of(object.path));
    return graph.diagram();
}

}  // namespace raylab::transforms
