#include "raylab/scene/toml/scene_format.h"

#include "raylab/scene/camera.h"
#include "raylab/scene/scene.h"

#include <memory>

namespace raylab::toml_file {

namespace {

Value value(double x) { return {.data = x}; }
Value value(const Vec3d& v) { return {.data = Value::Array{value(v.x), value(v.y), value(v.z)}}; }
Value whole(int x) { return {.data = std::int64_t{x}}; }
Value text(const std::string& word) { return {.data = word}; }

Format render_format() {
    return {
        Table{.what = "the way to render",
              .keys = {otherwise("model", {Word{{"auto", "whitted", "distributed", "path"}}}, text("auto"),
                                 "how light is followed; auto: distributed if something spreads rays, else whitted")}}};
}

Format image_format() {
    const Format side{Whole{1, largest_image_side}};
    return {Table{.what = "an image",
                  .keys = {otherwise("width", side, whole(ImageSize{}.width), "pixels"),
                           otherwise("height", side, whole(ImageSize{}.height), "pixels")}}};
}

// The keys that every camera has, followed by its own.
Tagged::Alternative camera(const std::string& word, const std::string& what, const Key& own) {
    const Table lens{.what = "a lens",
                     .keys = {required("radius", size(), "metres"),
                              required("focus", size(), "distance of the plane in focus, metres")}};
    return alternative(
        "type", word, what,
        {otherwise("position", vector(), value(Camera{}.position), "metres"),
         otherwise("target", vector(), value(Camera{}.target), "what the picture's centre shows, metres"),
         otherwise("up", vector(), value(Camera{}.up), "what is upward in the picture; need not be unit"), own,
         optional("lens", {lens}, "absent: a pinhole"),
         optional("shutter", array_of(2, number()), "opens and closes, seconds; absent: an instant")});
}

Format camera_format() {
    return {Tagged{
        .what = "a camera",
        .tag = "type",
        .alternatives = {camera("perspective", "a perspective camera",
                                otherwise("fov_y", {Number{.above = 0, .below = 180}}, value(Perspective{}.fov_y),
                                          "degrees between the top and the bottom edge of the picture")),
                         camera("orthographic", "an orthographic camera",
                                otherwise("height", size(), value(Orthographic{}.height), "of the picture, metres"))},
        .untagged = Tagged::Untagged::first}};
}

Format background_format() {
    return {Table{
        .what = "a background",
        .keys = {
            otherwise("color", light_color(), value(Background{}.color), "where no surface is seen"),
            optional("zenith", light_color(),
                     "a sky: `color` on the horizon, this straight up, along y; absent: `color` everywhere"),
            otherwise("ambient", light_color(), value(Background{}.ambient), "the light that comes from everywhere")}}};
}

Format pigment_format() {
    return {Either{{surface_color(),
                    {Tagged{.what = "a pattern",
                            .tag = "pattern",
                            .alternatives = {alternative("pattern", "checker", "a checker",
                                                         {required("a", surface_color(), "of one half of the cells"),
                                                          required("b", surface_color(), "of the other half"),
                                                          required("size", size(), "edge of a cell, metres")})}}}}}};
}

Format material_format() {
    const Material plain;
    return {Table{
        .what = "a material",
        .keys = {otherwise("ambient", surface_color(), value(plain.ambient), "share of the ambient light"),
                 otherwise("diffuse", pigment_format(), value(std::get<Color>(plain.diffuse)), "Lambert's term"),
                 otherwise("specular", surface_color(), value(plain.specular), "Phong's highlight of the lights"),
                 otherwise("shininess", at_least_zero(), value(plain.shininess), "Phong's exponent"),
                 otherwise("kr", from_zero_to_one(), value(plain.kr), "share reflected as by a mirror; kr + kt <= 1"),
                 otherwise("kt", from_zero_to_one(), value(plain.kt), "share transmitted; kr + kt <= 1"),
                 otherwise("ior", {Number{.above = 0}}, value(plain.ior), "index of refraction behind its front"),
                 otherwise("priority", {Whole{-1000, 1000}}, whole(plain.priority),
                           "where transparent objects overlap, the matter of the highest one counts"),
                 otherwise("emission", light_color(), value(plain.emission), "light it sends out itself"),
                 optional("gloss", at_least_zero(),
                          "exponent n: kr and kt spread as cos^n around their directions; absent: sharp"),
                 optional("roughness", {Number{.above = 0, .at_most = 1}},
                          "kr and kt spread as by facets (GGX), alpha = roughness^2; absent: sharp")}}};
}

// A light's own keys, followed by those that every light has.
Tagged::Alternative light(const std::string& word, const std::string& what, std::vector<Key> keys) {
    keys.push_back(otherwise("color", light_color(), value(Light{}.color), "linear RGB; may exceed 1"));
    return alternative("type", word, what, std::move(keys));
}

Format light_format() {
    const Key attenuation = otherwise("attenuation", array_of(3, at_least_zero()), value(Light{}.attenuation),
                                      "constant, linear and quadratic in the distance");
    return {Tagged{
        .what = "a light",
        .tag = "type",
        .alternatives = {
            light("point", "a point light", {required("position", vector(), "metres"), attenuation}),
            light("spot", "a spot light",
                  {required("position", vector(), "metres"), required("target", vector(), "metres"),
                   otherwise("cone", {Number{.above = 0, .at_most = 90}}, value(SpotLight{}.cone),
                             "half angle, degrees; no light outside"),
                   otherwise("exponent", at_least_zero(), value(SpotLight{}.exponent),
                             "cos^exponent of the angle inside the cone; 0: uniform"),
                   attenuation}),
            light("distant", "a distant light", {required("direction", vector(), "the way the light travels")})}}};
}

Format instance_format() {
    return {
        Table{.what = "an instance",
              .keys = {required("of", {Text{"the name of a group"}}, "the group it shows"),
                       optional("transform", transform_format(), "where it is placed; applied in order"),
                       optional("motion", vector(), "velocity, metres per second; absent: at rest"), transform_end()}}};
}

Format group_format() {
    return {Table{.what = "a group",
                  .keys = {optional("shapes", list_of(shape_format()), "its shapes"),
                           optional("instances", list_of(instance_format()), "other groups in it; no cycles")}}};
}

Format named(const std::string& what, const Format& element) {
    return {Named{.what = what, .element = std::make_shared<Format>(element)}};
}

}  // namespace

const Format& scene_format() {
    static const Format format{Table{
        .what = "a scene",
        .keys = {required("raylab", {Whole{1, 1}}, "version of the format"),
                 optional("include", list_of({Text{"a scene file"}}),
                          "scene files that belong to this one, each read once, before it; relative to its folder"),
                 optional("render", render_format(), "how the picture is made"),
                 optional("image", image_format(), "the picture"), optional("camera", camera_format(), "the eye"),
                 optional("background", background_format(), "what lies behind everything"),
                 optional("material", named("materials", material_format()), "materials by name, in Whitted's terms"),
                 optional("light", list_of(light_format()), "lights"),
                 optional("shape", list_of(shape_format()), "shapes, in the order that decides ties"),
                 optional("group", named("groups", group_format()), "shapes defined once, by name"),
                 optional("instance", list_of(instance_format()), "... and shown often")}}};
    return format;
}

}  // namespace raylab::toml_file
