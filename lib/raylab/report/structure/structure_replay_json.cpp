#include "raylab/report/structure/structure_replay_json.h"

#include "raylab/scene/check_shape.h"

#include <cmath>
#include <limits>

namespace raylab::replay {

using nlohmann::ordered_json;

ordered_json json_of(float number) {
    if (std::isfinite(number)) return double{number};
    return number > 0 ? "infinity" : number < 0 ? "-infinity" : "not a number";
}

ordered_json json_of(const Vec3f& v) { return {json_of(v.x), json_of(v.y), json_of(v.z)}; }

void Value::refuse(const std::string& expected) const {
    const std::string found = json_->is_structured() ? json_->type_name() : json_->dump();
    throw Error(place(), expected, found.size() > 60 ? found.substr(0, 60) + "..." : found);
}

Value Value::at(const std::string& name) const {
    if (!has(name)) refuse("a field \"" + name + "\"");
    return {(*json_)[name], file_, pointer_ + "/" + name};
}

Value Value::at(std::size_t index) const {
    if (index >= size()) refuse("at least " + std::to_string(index + 1) + " elements");
    return {(*json_)[index], file_, pointer_ + "/" + std::to_string(index)};
}

std::size_t Value::size() const {
    if (!json_->is_array()) refuse("an array");
    return json_->size();
}

float Value::number_or_infinity() const {
    if (*json_ == "infinity") return std::numeric_limits<float>::infinity();
    if (*json_ == "-infinity") return -std::numeric_limits<float>::infinity();
    return number();
}

double Value::exact_number() const {
    if (!json_->is_number() || !(std::abs(json_->get<double>()) <= std::numeric_limits<float>::max()))
        refuse("a finite number that fits a float");
    return json_->get<double>();
}

float Value::number() const { return static_cast<float>(exact_number()); }

std::uint32_t Value::whole() const {
    if (!json_->is_number_unsigned() || json_->get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
        refuse("a whole number");
    return json_->get<std::uint32_t>();
}

std::string Value::text() const {
    if (!json_->is_string()) refuse("a word");
    return json_->get<std::string>();
}

Vec3f Value::vector() const {
    if (size() != 3) refuse("three numbers");
    return {at(0).number(), at(1).number(), at(2).number()};
}

namespace {

// The fields of a shape by name, listed once for reading and writing: a Field is called with each.
template <class Field>
void fields(Sphere& s, const Field& field) {
    field("center", s.center), field("radius", s.radius);
}
template <class Field>
void fields(Ellipsoid& e, const Field& field) {
    field("center", e.center), field("radii", e.radii);
}
template <class Field>
void fields(Cylinder& c, const Field& field) {
    field("base", c.base), field("top", c.top), field("radius", c.radius), field("ends", c.ends);
}
template <class Field>
void fields(Cone& c, const Field& field) {
    field("base", c.base), field("top", c.top), field("base_radius", c.base_radius), field("top_radius", c.top_radius),
        field("ends", c.ends);
}
template <class Field>
void fields(Paraboloid& p, const Field& field) {
    field("base", p.base), field("top", p.top), field("radius", p.radius), field("ends", p.ends);
}
template <class Field>
void fields(Hyperboloid& h, const Field& field) {
    field("base", h.base), field("top", h.top), field("waist", h.waist), field("radius", h.radius),
        field("ends", h.ends);
}
template <class Field>
void fields(Plane& p, const Field& field) {
    field("point", p.point), field("normal", p.normal);
}
template <class Field>
void fields(Disk& d, const Field& field) {
    field("center", d.center), field("normal", d.normal), field("radius", d.radius);
}
template <class Field>
void fields(Annulus& a, const Field& field) {
    field("center", a.center), field("normal", a.normal), field("inner_radius", a.inner_radius),
        field("outer_radius", a.outer_radius);
}
template <class Field>
void fields(Polygon& p, const Field& field) {
    field("vertices", p.vertices);
}
template <class Field>
void fields(Triangle& t, const Field& field) {
    field("a", t.a), field("b", t.b), field("c", t.c);
}
template <class Field>
void fields(Mesh& m, const Field& field) {
    field("vertices", m.vertices), field("faces", m.faces);
}

constexpr const char* shape_names[] = {"sphere", "ellipsoid", "cylinder", "cone",    "paraboloid", "hyperboloid",
                                       "plane",  "disk",      "annulus",  "polygon", "triangle",   "mesh"};
static_assert(std::size(shape_names) == std::variant_size_v<Shape>, "a name for every shape, in the variant's order");

struct Write {
    ordered_json& json;
    void operator()(const char* name, float number) const { json[name] = json_of(number); }
    void operator()(const char* name, const Vec3f& vector) const { json[name] = json_of(vector); }
    void operator()(const char* name, Ends ends) const { json[name] = ends == Ends::open ? "open" : "capped"; }
    void operator()(const char* name, const std::vector<Vec3f>& points) const {
        json[name] = ordered_json::array();
        for (const Vec3f& point : points) json[name].push_back(json_of(point));
    }
    void operator()(const char* name, const std::vector<Mesh::Face>& faces) const {
        json[name] = ordered_json::array();
        for (const auto& [a, b, c] : faces) json[name].push_back({a, b, c});
    }
};

struct Read {
    const Value& value;
    void operator()(const char* name, float& number) const { number = value.at(name).number(); }
    void operator()(const char* name, Vec3f& vector) const { vector = value.at(name).vector(); }
    void operator()(const char* name, Ends& ends) const {
        const std::string word = value.at(name).text();
        if (word != "open" && word != "capped") value.at(name).refuse("\"open\" or \"capped\"");
        ends = word == "open" ? Ends::open : Ends::capped;
    }
    void operator()(const char* name, std::vector<Vec3f>& points) const {
        for (std::size_t i = 0; i < value.at(name).size(); ++i) points.push_back(value.at(name).at(i).vector());
    }
    void operator()(const char* name, std::vector<Mesh::Face>& faces) const {
        for (std::size_t i = 0; i < value.at(name).size(); ++i) {
            const Value face = value.at(name).at(i);
            faces.push_back({face.at(0).whole(), face.at(1).whole(), face.at(2).whole()});
        }
    }
};

template <class T>
Shape shape_of(const Value& value) {
    T shape{};
    fields(shape, Read{value});
    return shape;
}

Shape mesh_of(const Value& value) {
    auto mesh = std::make_shared<Mesh>();
    fields(*mesh, Read{value});
    for (const auto& [a, b, c] : mesh->faces)
        if (std::max({a, b, c}) >= mesh->vertices.size()) value.at("faces").refuse("indices of vertices");
    return mesh;
}

// A placement, or a motion: both have columns and a translation.
template <class Map>
ordered_json json_of_map(const Map& map) {
    ordered_json json{{"columns", ordered_json::array()}};
    for (const Vec3f& column : map.columns) json["columns"].push_back(json_of(column));
    json["translation"] = json_of(map.translation);
    return json;
}

template <class Map>
Map map_of(const Value& value) {
    Map map;
    for (std::size_t i = 0; value.has("columns") && i < 3; ++i) map.columns[i] = value.at("columns").at(i).vector();
    if (value.has("translation")) map.translation = value.at("translation").vector();
    return map;
}

}  // namespace

ordered_json json_of(const Object& object) {
    ordered_json json{{"shape", shape_names[object.shape.index()]}};
    Shape shape = object.shape;
    if (const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape)) {
        Mesh copy = **mesh;
        fields(copy, Write{json});
    } else {
        std::visit(
            [&](auto& one) {
                if constexpr (requires { fields(one, Write{json}); }) fields(one, Write{json});
            },
            shape);
    }
    if (!object.placement.is_identity()) json.update(json_of_map(object.placement));
    if (object.motion) json["motion"] = json_of_map(*object.motion);
    if (object.sides != Sides::both) json["sides"] = object.sides == Sides::front ? "front" : "back";
    return json;
}

Object object_of(const Value& value) {
    using Reader = Shape (*)(const Value&);
    constexpr Reader readers[] = {shape_of<Sphere>,     shape_of<Ellipsoid>,   shape_of<Cylinder>, shape_of<Cone>,
                                  shape_of<Paraboloid>, shape_of<Hyperboloid>, shape_of<Plane>,    shape_of<Disk>,
                                  shape_of<Annulus>,    shape_of<Polygon>,     shape_of<Triangle>, mesh_of};
    static_assert(std::size(readers) == std::size(shape_names));
    const std::string name = value.at("shape").text();
    std::size_t index = 0;
    while (index < std::size(readers) && shape_names[index] != name) ++index;
    if (index == std::size(readers)) value.at("shape").refuse("a shape's name");
    Object object{.shape = readers[index](value)};
    check_shape(object.shape, value.place());
    object.placement = map_of<Affine>(value);
    if (value.has("motion")) object.motion = map_of<Motion>(value.at("motion"));
    check_placement(object.placement, value.place());
    if (value.has("sides")) {
        const std::string sides = value.at("sides").text();
        if (sides != "front" && sides != "back") value.at("sides").refuse("\"front\" or \"back\"");
        object.sides = sides == "front" ? Sides::front : Sides::back;
    }
    return object;
}

}  // namespace raylab::replay
