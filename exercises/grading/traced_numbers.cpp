#include "traced_numbers.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace raylab::grading {

namespace {

// The textbook's tracer has these kinds of rays and no diffuse ones, and any ending.
constexpr std::size_t kinds = static_cast<std::size_t>(RayKind::shadow) + 1;
constexpr std::size_t endings = static_cast<std::size_t>(Ending::blocked) + 1;
constexpr std::size_t max_nodes = 4096;  // a right tree of the traced scene has some hundred

// Writer and reader have the same sequence of fields.
class Writer {
public:
    explicit Writer(std::span<double> out) : out_(out) {}
    void number(double value) { out_[at_++] = value; }
    void vector(const Vec3d& v) {
        for (int i = 0; i < 3; ++i) number(v[i]);
    }
    void index(std::size_t value) { number(value == RayNode::none ? -1 : static_cast<double>(value)); }
    std::size_t written() const { return at_; }

private:
    std::span<double> out_;
    std::size_t at_ = 0;
};

class Reader {
public:
    explicit Reader(std::span<const double> in) : in_(in) {}
    double number() { return in_[at_++]; }
    Vec3d vector() {
        const double x = number(), y = number();
        return {x, y, number()};
    }
    // An integer from `lowest` to below `end`; absent for anything else, including NaN.
    std::optional<long> whole(long lowest, std::size_t end) {
        const double value = number();
        if (!(value >= static_cast<double>(lowest) && value < static_cast<double>(end)) || value != std::floor(value))
            return std::nullopt;
        return static_cast<long>(value);
    }

private:
    std::span<const double> in_;
    std::size_t at_ = 0;
};

std::size_t object_number(const Scene& scene, const std::string& path) {
    const auto found = std::ranges::find(scene.objects, path, &Object::path);
    return found == scene.objects.end() ? RayNode::none : static_cast<std::size_t>(found - scene.objects.begin());
}

std::size_t index_of(long number) { return number < 0 ? RayNode::none : static_cast<std::size_t>(number); }

std::optional<RayNode> node_of(const Scene& scene, std::span<const double> numbers, std::size_t place) {
    Reader in(numbers.subspan(4));
    const auto kind = in.whole(0, kinds), ended = in.whole(0, endings), parent = in.whole(-1, place),
               light = in.whole(-1, scene.lights.size());
    const auto object = in.whole(-1, scene.objects.size()), depth = in.whole(-1000, 1000);
    if (!kind || !ended || !parent || !light || !object || !depth || (*parent < 0) != (place == 0)) return std::nullopt;
    RayNode node{.kind = static_cast<RayKind>(*kind),
                 .ended = static_cast<Ending>(*ended),
                 .parent = index_of(*parent),
                 .light = index_of(*light),
                 .depth = static_cast<int>(*depth),
                 .object = *object < 0 ? "" : scene.objects[static_cast<std::size_t>(*object)].path};
    node.throughput = in.number();
    node.t = in.number();
    node.ray.origin = convert<float>(in.vector());
    node.ray.direction = convert<float>(in.vector());
    node.point = in.vector();
    node.normal = in.vector();
    node.local = in.vector();
    node.contribution = node.throughput * node.local;
    return node;
}

}  // namespace

void write_traced(const TracedScene& traced, std::span<const double> input, std::span<double> output) {
    const RayTree tree = traced.tree(static_cast<int>(input[0]), static_cast<int>(input[1]));
    const auto place = std::min(static_cast<std::size_t>(input[2]), tree.nodes.size() - 1);
    const RayNode& node = tree.nodes[place];
    Writer out(output);
    out.vector(tree.pixel);
    out.number(static_cast<double>(tree.nodes.size()));
    out.number(static_cast<double>(node.kind));
    out.number(static_cast<double>(node.ended));
    out.index(node.parent);
    out.index(node.light);
    out.index(node.object.empty() ? RayNode::none : object_number(traced.scene, node.object));
    out.number(node.depth);
    out.number(node.throughput);
    out.number(node.t);
    for (const auto& v :
         {convert<double>(node.ray.origin), convert<double>(node.ray.direction), node.point, node.normal, node.local})
        out.vector(v);
    assert(out.written() == traced_outputs);
}

Color traced_color_of(std::span<const double> output) { return Reader(output).vector(); }

std::size_t traced_nodes_of(std::span<const double> output) {
    return static_cast<std::size_t>(Reader(output.subspan(3)).whole(0, max_nodes + 1).value_or(0));
}

std::optional<RayTree> traced_tree(const TracedScene& traced, std::span<const double> outputs) {
    if (outputs.empty() || outputs.size() % traced_outputs != 0) return std::nullopt;
    RayTree tree{.nodes = {}, .pixel = traced_color_of(outputs)};
    for (std::size_t i = 0; i < outputs.size() / traced_outputs; ++i) {
        const auto node = node_of(traced.scene, outputs.subspan(i * traced_outputs, traced_outputs), i);
        if (!node) return std::nullopt;
        tree.nodes.push_back(*node);
    }
    return tree;
}

}  // namespace raylab::grading
