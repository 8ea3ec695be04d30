#include "raylab/report/ray_tree/pixel_trees.h"

#include "raylab/geometry/shape_parts.h"
#include "raylab/report/plane/plane_view.h"
#include "raylab/tracer/picture/whitted_picture.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace raylab {

namespace {

using Json = nlohmann::ordered_json;

constexpr ImageSize grid{32, 24};
constexpr std::size_t most_outlines = 2000;  // of a scene: more are not to be told apart

// Rounded to this many digits the file is a third as long.
Json rounded_number(double value, int digits = 6) {
    if (!std::isfinite(value)) return nullptr;
    return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

void append(Json& list, const Vec3d& v) {
    for (const double x : {v.x, v.y, v.z}) list.push_back(rounded_number(x));
}

// Kinds, endings and objects' names occur often: a node has a word's place in the list.
class Words {
public:
    std::size_t place(const std::string& word) {
        const auto [found, is_new] = places_.try_emplace(word, places_.size());
        if (is_new) all_.push_back(word);
        return found->second;
    }
    const Json& all() const { return all_; }

private:
    std::map<std::string, std::size_t> places_;
    Json all_ = Json::array();
};

// The box about what the rays hit, the eye and the lights: what a view shows. Rays to infinity leave it.
class Space {
public:
    explicit Space(const Vec3d& eye) : low_(eye), high_(eye) {}
    void add(const Vec3d& point) {
        low_ = glm::min(low_, point);
        high_ = glm::max(high_, point);
    }
    Box box() const { return {convert<float>(low_), convert<float>(high_)}; }

private:
    Vec3d low_, high_;
};

Json to_json(const RayTree& tree, Words& words, Space& space) {
    Json nodes = Json::array();
    for (const RayNode& node : tree.nodes) {
        Json json = {words.place(to_string(node.kind)), words.place(to_string(node.ended)),
                     node.parent == RayNode::none ? Json(nullptr) : Json(node.parent), rounded_number(node.throughput)};
        if (was_cast(node)) {
            const bool is_shadow = node.kind == RayKind::shadow;
            json.push_back(is_shadow ? node.light : words.place(node.object));
            json.push_back(
                rounded_number(is_shadow ? cast<double>(node.ray.range.max) : node.t));  // as far as its light
            append(json, convert<double>(node.ray.origin));
            append(json, convert<double>(node.ray.direction));
            if (!is_shadow) append(json, node.local);
            if (!is_shadow && std::isfinite(node.t)) space.add(node.point);
        }
        nodes.push_back(std::move(json));
    }
    return nodes;
}

Json trees_of(const PickedPicture& picture, const CameraFrame& frame, Words& words, Space& space) {
    const auto middle = [](int cell, int cells, int pixels) { return (2 * cell + 1) * pixels / (2 * cells); };
    Json trees = Json::array();
    for (int row = 0; row < grid.height; ++row)
        for (int column = 0; column < grid.width; ++column) {
            const PixelSample sample{middle(column, grid.width, picture.image.width),
                                     middle(row, grid.height, picture.image.height)};
            const RayTree tree = sample_tree(picture.scene, picture.accelerator, frame, picture.options,
                                             {SamplePattern::center, 1}, sample);
            trees.push_back({sample.x, sample.y, to_json(tree, words, space)});
        }
    return trees;
}

Json outlines_of(const Scene& scene, const PlaneView& view) {
    Json outlines = Json::array();
    for (const Object& object : scene.objects)
        for (std::uint32_t part = 0; part < part_count(object.shape); ++part)
            for (const Wires& piece : wires_of(object.shape, part, object.placement)) {
                const auto figure = view.figure(piece);
                if (!figure || outlines.size() == most_outlines) continue;
                Json corners = Json::array();
                for (const PlanePoint& corner : std::get<PlanePolygon>(*figure).corners)
                    for (const double x : {corner.x, corner.y}) corners.push_back(rounded_number(x, 4));
                outlines.push_back(std::move(corners));
            }
    return outlines;
}

// How a point of space stands in the view: its products with `right` and `up`.
Json view_of(const Scene& scene, const std::string& words, int along, const Box& shown) {
    const PlaneView view(along, std::nullopt, shown);
    const PlanePoint x = view.at({1, 0, 0}), y = view.at({0, 1, 0}), z = view.at({0, 0, 1});
    const PlanePoint a = view.at(convert<double>(shown.min)), b = view.at(convert<double>(shown.max));
    return {{"words", words},
            {"right", {x.x, y.x, z.x}},
            {"up", {x.y, y.y, z.y}},
            {"low", {rounded_number(std::min(a.x, b.x), 4), rounded_number(std::min(a.y, b.y), 4)}},
            {"high", {rounded_number(std::max(a.x, b.x), 4), rounded_number(std::max(a.y, b.y), 4)}},
            {"outlines", outlines_of(scene, view)}};
}

}  // namespace

std::string pixel_trees_script(const PickedPicture& picture) {
    const CameraFrame frame = camera_frame(picture.scene.camera, picture.image, picture.scene.source);
    Words words;
    Space space(frame.eye);
    const Json trees = trees_of(picture, frame, words, space);
    for (const Light& light : picture.scene.lights)
        if (const auto* point = std::get_if<PointLight>(&light.kind)) space.add(point->position);
    const Json json = {{"command", picture.command},
                       {"image", {picture.image.width, picture.image.height}},
                       {"grid", {grid.width, grid.height}},
                       {"words", words.all()},
                       {"views",
                        {view_of(picture.scene, "from above", 1, space.box()),
                         view_of(picture.scene, "from the side", 0, space.box())}},
                       {"trees", trees}};
    return "raylab_trees(" + json.dump() + ");\n";
}

}  // namespace raylab
