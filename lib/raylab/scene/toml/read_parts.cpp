#include "raylab/scene/toml/read_parts.h"

#include "raylab/scene/render_model.h"

#include <fmt/format.h>

namespace raylab::toml_file {

namespace {

std::variant<Perspective, Orthographic> read_projection(const Node& node) {
    if (node.tag() == "orthographic") return Orthographic{node.number("height")};
    return Perspective{node.number("fov_y")};
}

Shutter read_shutter(const Node& node) {
    const auto& times = std::get<Value::Array>(node.value("shutter").data);
    const Shutter shutter{.open = number_of(times.at(0)), .close = number_of(times.at(1))};
    if (shutter.open > shutter.close)
        throw Error(node.place("shutter"), "a shutter that opens before it closes",
                    fmt::format("[{}, {}]", shutter.open, shutter.close));
    return shutter;
}

Pigment read_diffuse(const Node& node) {
    const bool is_pattern = std::holds_alternative<Value::Table>(node.value("diffuse").data);
    if (!is_pattern) return node.vector("diffuse");
    const auto checker = node.choice("diffuse");
    return Checker{checker.vector("a"), checker.vector("b"), checker.number("size")};
}

SpotLight read_spot(const Node& node) {
    const SpotLight spot{node.vector("position"), node.vector("target"), node.number("cone"), node.number("exponent")};
    if (spot.position == spot.target)
        throw Error(node.place("target"), "a spot light whose target is not its position", "both at the same point");
    return spot;
}

DistantLight read_distant(const Node& node) {
    const auto direction = node.vector("direction");
    if (direction == Vec3d{0, 0, 0}) throw Error(node.place("direction"), "a direction that is not zero", "[0, 0, 0]");
    return {direction};
}

Vec3d read_attenuation(const Node& node) {
    const auto attenuation = node.vector("attenuation");
    if (attenuation == Vec3d{0, 0, 0})  // the light is divided by it
        throw Error(node.place("attenuation"), "an attenuation that is not zero", "[0, 0, 0]");
    return attenuation;
}

// A lens that is wider than its focus is far sees hardly anything of what it looks at.
Lens read_lens(const Node& node) {
    const Lens lens{node.number("radius"), node.number("focus")};
    if (lens.radius > lens.focus)
        throw Error(node.place("radius"), fmt::format("a radius of at most the distance of the focus, {}", lens.focus),
                    fmt::format("{}", lens.radius));
    return lens;
}

Polish read_polish(const Node& node) {
    if (node.has("gloss") && node.has("roughness")) throw Error(node.place("roughness"), "gloss or roughness", "both");
    if (node.has("gloss")) return Gloss{node.number("gloss")};
    if (node.has("roughness")) return Roughness{node.number("roughness")};
    return Sharp{};
}

}  // namespace

RenderModel read_model(const Node& node) { return *render_model(node.text("model")); }

ImageSize read_image(const Node& node) { return {node.whole("width"), node.whole("height")}; }

Camera read_camera(const Node& node) {
    Camera camera{.position = node.vector("position"),
                  .target = node.vector("target"),
                  .up = node.vector("up"),
                  .projection = read_projection(node)};
    if (node.has("lens")) camera.lens = read_lens(node.table("lens"));
    if (node.has("shutter")) camera.shutter = read_shutter(node);
    return camera;
}

Background read_background(const Node& node) {
    Background background{.color = node.vector("color"), .ambient = node.vector("ambient")};
    if (node.has("zenith")) background.zenith = node.vector("zenith");
    return background;
}

Material read_material(const Node& node, const std::string& name) {
    const Material material{.name = name,
                            .ambient = node.vector("ambient"),
                            .diffuse = read_diffuse(node),
                            .specular = node.vector("specular"),
                            .shininess = node.number("shininess"),
                            .kr = node.number("kr"),
                            .kt = node.number("kt"),
                            .ior = node.number("ior"),
                            .priority = node.whole("priority"),
                            .emission = node.vector("emission"),
                            .polish = read_polish(node)};
    if (material.kr + material.kt > 1)
        throw Error(node.place(node.has("kt") ? "kt" : "kr"), "kr + kt <= 1",
                    fmt::format("{}", material.kr + material.kt));
    return material;
}

Light read_light(const Node& node) {
    if (node.tag() == "distant") return {.kind = read_distant(node), .color = node.vector("color")};
    Light light{.kind = PointLight{node.vector("position")},
                .color = node.vector("color"),
                .attenuation = read_attenuation(node)};
    if (node.tag() == "spot") light.kind = read_spot(node);
    return light;
}

}  // namespace raylab::toml_file
