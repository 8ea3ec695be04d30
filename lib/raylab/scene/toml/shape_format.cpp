#include "raylab/scene/toml/scene_format.h"

#include <utility>

namespace raylab::toml_file {

namespace {

Format material_reference() {
    const Format name{Text{"the name of a material"}};
    const Table sides{.what = "a pair of materials",
                      .keys = {required("front", name, "material of the side the normal points to"),
                               required("back", name, "material of the other side")}};
    return {Either{{name, {sides}}}};
}

Key ends() {
    return otherwise("ends", {Word{{"open", "capped"}}}, {.data = "open"},
                     "whether disks close the surface where its axis ends");
}

Key base() { return required("base", vector(), "where the axis begins, metres"); }
Key top() { return required("top", vector(), "where the axis ends, metres"); }

// A shape's own keys, followed by those that every shape has.
Tagged::Alternative shape(const std::string& word, const std::string& what, std::vector<Key> keys) {
    keys.push_back(optional("material", material_reference(), "its material; absent: plain grey"));
    keys.push_back(otherwise("sides", {Word{{"both", "front", "back"}}}, {.data = "both"},
                             "the sides it is seen from; the normal points to the front"));
    keys.push_back(optional("transform", transform_format(), "where it is placed; applied in order"));
    keys.push_back(optional("motion", vector(), "velocity after the transform, metres per second; absent: at rest"));
    keys.push_back(transform_end());
    return alternative("type", word, what, std::move(keys));
}

}  // namespace

Key transform_end() {
    return optional(
        "transform_end", transform_format(),
        "instead of a motion: the transform when the shutter closes, from that of time 0 in straight lines");
}

Format transform_format() {
    const Table rotation{.what = "a rotation",
                         .keys = {required("axis", vector(), "need not be unit"),
                                  required("degrees", number(), "right-handed about the axis")}};
    const Table step{.what = "a transform step",
                     .keys = {optional("translate", vector(), "metres"),
                              optional("scale", {Either{{coordinate(), vector()}}}, "one factor, or one for each axis"),
                              optional("rotate", {rotation}, "about an axis through the origin"),
                              optional("matrix", array_of(12, coordinate()),
                                       "three rows of a 3 x 4 matrix (a shear, say); its last column translates")},
                     .given = Keys::exactly_one};
    return list_of({step});
}

Format shape_format() {
    return {Tagged{
        .what = "a shape",
        .tag = "type",
        .alternatives = {
            shape("sphere", "a sphere", {required("center", vector(), "metres"), required("radius", size(), "metres")}),
            shape("ellipsoid", "an ellipsoid",
                  {required("center", vector(), "metres"),
                   required("radii", array_of(3, size()), "along x, y and z, metres")}),
            shape("cylinder", "a cylinder", {base(), top(), required("radius", size(), "metres"), ends()}),
            shape("cone", "a cone",
                  {base(), top(),
                   required("base_radius", {Number{.at_least = 0, .stored = Stored::as_float}}, "metres; 0: an apex"),
                   otherwise("top_radius", {Number{.at_least = 0, .stored = Stored::as_float}}, {.data = 0.0},
                             "metres; 0: an apex"),
                   ends()}),
            shape("paraboloid", "a paraboloid",
                  {base(), top(), required("radius", size(), "at the top, metres; its vertex is the base"), ends()}),
            shape("hyperboloid", "a hyperboloid",
                  {base(), top(), required("waist", size(), "radius halfway, metres"),
                   required("radius", size(), "at both ends, metres; at least the waist"), ends()}),
            shape("plane", "a plane",
                  {required("point", vector(), "metres"), required("normal", vector(), "need not be unit")}),
            shape("disk", "a disk",
                  {required("center", vector(), "metres"), required("normal", vector(), "need not be unit"),
                   required("radius", size(), "metres")}),
            shape("annulus", "an annulus",
                  {required("center", vector(), "metres"), required("normal", vector(), "need not be unit"),
                   required("inner_radius", size(), "of the hole, metres"),
                   required("outer_radius", size(), "metres; above the inner radius")}),
            shape("polygon", "a polygon",
                  {required("vertices", list_of(vector(), 3), "metres, counter-clockwise seen from its front")}),
            shape("triangle", "a triangle",
                  {required("vertices", array_of(3, vector()), "metres, counter-clockwise seen from its front")}),
            shape("mesh", "a mesh",
                  {required("file", {Text{"a mesh file"}}, "OFF, OBJ, PLY or STL, relative to this file's folder"),
                   optional("shading", {Word{{"flat", "gouraud", "phong"}}},
                            "light by each triangle's normal, colours between the vertices', or normals between "
                            "theirs (made where the file has none); absent: phong where it has some, else flat")}),
        }}};
}

}  // namespace raylab::toml_file
