#include "raylab/scene/check_shape.h"
#include "raylab/scene/toml/read_parts.h"

#include <cassert>
#include <functional>
#include <map>

namespace raylab::toml_file {

namespace {

Vec3f point(const Node& node, std::string_view key) { return convert<float>(node.vector(key)); }
float length(const Node& node, std::string_view key) { return cast<float>(node.number(key)); }
Ends ends(const Node& node) { return node.text("ends") == "capped" ? Ends::capped : Ends::open; }

std::vector<Vec3f> vertices(const Node& node) {
    std::vector<Vec3f> result;
    for (const auto& each : std::get<Value::Array>(node.value("vertices").data))
        result.push_back(convert<float>(vector_of(each)));
    return result;
}

Shape sphere(const Node& node) { return Sphere{point(node, "center"), length(node, "radius")}; }
Shape ellipsoid(const Node& node) { return Ellipsoid{point(node, "center"), point(node, "radii")}; }
Shape cylinder(const Node& node) {
    return Cylinder{point(node, "base"), point(node, "top"), length(node, "radius"), ends(node)};
}
Shape cone(const Node& node) {
    return Cone{point(node, "base"), point(node, "top"), length(node, "base_radius"), length(node, "top_radius"),
                ends(node)};
}
Shape paraboloid(const Node& node) {
    return Paraboloid{point(node, "base"), point(node, "top"), length(node, "radius"), ends(node)};
}
Shape hyperboloid(const Node& node) {
    return Hyperboloid{point(node, "base"), point(node, "top"), length(node, "waist"), length(node, "radius"),
                       ends(node)};
}
Shape plane(const Node& node) { return Plane{point(node, "point"), point(node, "normal")}; }
Shape disk(const Node& node) { return Disk{point(node, "center"), point(node, "normal"), length(node, "radius")}; }
Shape annulus(const Node& node) {
    return Annulus{point(node, "center"), point(node, "normal"), length(node, "inner_radius"),
                   length(node, "outer_radius")};
}
Shape polygon(const Node& node) { return Polygon{vertices(node)}; }
Shape triangle(const Node& node) {
    const auto corners = vertices(node);
    return Triangle{corners.at(0), corners.at(1), corners.at(2)};
}

}  // namespace

Shape read_shape(const Node& node) {
    static const std::map<std::string, std::function<Shape(const Node&)>> readers{
        {"sphere", sphere},         {"ellipsoid", ellipsoid},     {"cylinder", cylinder}, {"cone", cone},
        {"paraboloid", paraboloid}, {"hyperboloid", hyperboloid}, {"plane", plane},       {"disk", disk},
        {"annulus", annulus},       {"polygon", polygon},         {"triangle", triangle}};
    const auto reader = readers.find(node.tag());
    assert(reader != readers.end() && "every shape of the format has a reader");
    const auto shape = reader->second(node);
    check_shape(shape, node.place());
    return shape;
}

}  // namespace raylab::toml_file
