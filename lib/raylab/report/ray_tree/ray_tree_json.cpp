#include "raylab/report/ray_tree/ray_tree_json.h"

#include "raylab/base/error.h"
#include "raylab/base/read_json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace raylab {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format = "ray tree";
// Former words, which older files have.
constexpr const char* former_throughput = "weight";
constexpr const char* former_internal_reflection = "total reflection";

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json numbers(const Vec3d& v) { return {number(v.x), number(v.y), number(v.z)}; }
Json index(std::size_t value) { return value == RayNode::none ? Json(nullptr) : Json(value); }

Json to_json(const Ray& ray) {
    Json json{{"origin", numbers(convert<double>(ray.origin))},
              {"direction", numbers(convert<double>(ray.direction))},
              {"range", {number(cast<double>(ray.range.min)), number(cast<double>(ray.range.max))}},
              {"leaving", nullptr}};
    if (ray.leaving != no_primitive) json["leaving"] = {ray.leaving.object, ray.leaving.part};
    if (ray.time != 0) json["time"] = number(cast<double>(ray.time));
    return json;
}

Json to_json(const RayNode& node) {
    Json json{{"kind", to_string(node.kind)},
              {"ended", to_string(node.ended)},
              {"parent", index(node.parent)},
              {"light", index(node.light)},
              {"depth", node.depth},
              {"throughput", node.throughput},
              {"ray", was_cast(node) ? to_json(node.ray) : Json(nullptr)},
              {"object", node.object},
              {"t", number(node.t)},
              {"point", numbers(node.point)},
              {"normal", numbers(node.normal)},
              {"local", numbers(node.local)},
              {"contribution", numbers(node.contribution)}};
    if (node.density > 0) json["density"] = number(node.density);
    if (node.samples != 1) json["samples"] = node.samples;
    return json;
}

// A value of the file, with its place for errors.
class Value {
public:
    Value(const Json& json, const std::string& source, std::string at)
        : json_(json), source_(source), at_(std::move(at)) {}

    [[noreturn]] void refuse(const std::string& expected) const {
        throw Error({source_, 0, at_}, expected, json_.dump().substr(0, 80));
    }
    bool has(const std::string& key) const { return json_.is_object() && json_.contains(key); }
    Value operator[](const std::string& key) const {
        if (!json_.is_object()) refuse("an object");
        const auto found = json_.find(key);
        if (found == json_.end()) throw Error({source_, 0, at_ + "/" + key}, "a value", "none");
        return {*found, source_, at_ + "/" + key};
    }
    Value operator[](std::size_t i) const { return {json_[i], source_, at_ + "/" + std::to_string(i)}; }

    bool is_null() const { return json_.is_null(); }
    std::size_t size() const { return json_.is_array() ? json_.size() : (refuse("an array"), 0); }
    std::string text() const { return json_.is_string() ? json_.get<std::string>() : (refuse("a text"), ""); }
    double number() const { return json_.is_number() ? json_.get<double>() : (refuse("a number"), 0); }
    double number_or_infinity() const { return is_null() ? std::numeric_limits<double>::infinity() : number(); }
    // NaN has no spelling in JSON except null.
    double number_or_nan() const { return is_null() ? std::nan("") : number(); }
    // A number that is too large for a float would be read as infinite, and no ray has such a number.
    float number_as_float() const {
        if (std::abs(number_or_nan()) > std::numeric_limits<float>::max()) refuse("a number that a float can be");
        return static_cast<float>(number_or_nan());
    }
    std::size_t index(std::size_t end) const {
        if (!json_.is_number_unsigned() || json_.get<std::size_t>() >= end)
            refuse("a whole number below " + std::to_string(end));
        return json_.get<std::size_t>();
    }
    int integer() const {
        constexpr int largest = 1 << 30;
        if (!json_.is_number_integer() || json_.get<double>() < -largest || json_.get<double>() > largest)
            refuse("a whole number");
        return json_.get<int>();
    }
    Vec3d vector() const {
        if (size() != 3) refuse("three numbers");
        return {(*this)[0].number_or_nan(), (*this)[1].number_or_nan(), (*this)[2].number_or_nan()};
    }
    Vec3f vector_of_floats() const {
        if (size() != 3) refuse("three numbers");
        return {(*this)[0].number_as_float(), (*this)[1].number_as_float(), (*this)[2].number_as_float()};
    }

private:
    const Json& json_;
    const std::string& source_;
    std::string at_;
};

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t any_index = std::numeric_limits<std::uint32_t>::max();

Ray ray_of(const Value& value) {
    const Value range = value["range"], leaving = value["leaving"];
    if (range.size() != 2) range.refuse("two numbers");
    if (range[0].is_null()) range[0].refuse("a number");
    Ray ray{.origin = value["origin"].vector_of_floats(),
            .direction = value["direction"].vector_of_floats(),
            .range = {range[0].number_as_float(), range[1].is_null() ? infinity : range[1].number_as_float()}};
    if (value.has("time")) ray.time = value["time"].number_as_float();
    if (leaving.is_null()) return ray;
    if (leaving.size() != 2) leaving.refuse("an object's and a part's index");
    ray.leaving = {static_cast<std::uint32_t>(leaving[0].index(any_index)),
                   static_cast<std::uint32_t>(leaving[1].index(any_index))};
    return ray;
}

RayNode node_of(const Value& value, std::size_t number) {
    const auto kind = ray_kind(value["kind"].text());
    if (!kind) value["kind"].refuse("eye, reflected, transmitted, diffuse or shadow");
    const std::string end = value["ended"].text();
    const auto ended = end == former_internal_reflection ? Ending::total_internal_reflection : ending(end);
    if (!ended) value["ended"].refuse("an ending (branched, diffuse, depth, threshold, missed, ...)");
    RayNode node{.kind = *kind,
                 .ended = *ended,
                 .depth = value["depth"].integer(),
                 .throughput = value[value.has(former_throughput) ? former_throughput : "throughput"].number_or_nan(),
                 .object = value["object"].text(),
                 .t = value["t"].number_or_infinity(),
                 .point = value["point"].vector(),
                 .normal = value["normal"].vector(),
                 .local = value["local"].vector(),
                 .contribution = value["contribution"].vector()};
    if (number > 0)
        node.parent = value["parent"].index(number);  // parents come before their children
    else if (!value["parent"].is_null())
        value["parent"].refuse("null, since the first node is the eye ray's");
    if (!value["light"].is_null()) node.light = value["light"].index(any_index);
    if (!value["ray"].is_null()) node.ray = ray_of(value["ray"]);
    if (value.has("density")) node.density = value["density"].number_or_infinity();
    if (value.has("samples")) node.samples = value["samples"].index(any_index);
    return node;
}

RayTree ray_tree_of(const Json& json, const std::string& source) {
    const Value value(json, source, "");
    if (!json.is_object() || value["raylab"].text() != format)
        throw Error({source}, "a ray tree ({\"raylab\": \"ray tree\", ...})", "other JSON");
    const Value nodes = value["nodes"];
    if (nodes.size() == 0) nodes.refuse("at least the eye ray's node");
    RayTree tree{.pixel = value["pixel"].vector()};
    for (std::size_t i = 0; i < nodes.size(); ++i) tree.nodes.push_back(node_of(nodes[i], i));
    return tree;
}

}  // namespace

nlohmann::ordered_json to_json(const RayTree& tree) {
    Json json{{"raylab", format}, {"pixel", numbers(tree.pixel)}, {"nodes", Json::array()}};
    for (const auto& node : tree.nodes) json["nodes"].push_back(to_json(node));
    return json;
}

RayTree ray_tree_from_json(std::string_view text, const std::string& source, const MemoryLimit& limit) {
    return ray_tree_of(json_from_text(text, source, limit), source);
}

RayTree read_ray_tree(const std::filesystem::path& path, const MemoryLimit& limit) {
    return ray_tree_of(read_json(path, limit), path.string());
}

}  // namespace raylab
