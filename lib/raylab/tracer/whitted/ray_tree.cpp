#include "raylab/tracer/whitted/ray_tree.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace raylab {

namespace {

constexpr std::array<std::string_view, 5> kinds{"eye", "reflected", "transmitted", "shadow", "diffuse"};
constexpr std::array<std::string_view, 9> endings{
    "branched", "diffuse", "depth", "threshold", "roulette", "missed", "total internal reflection",
    "reached",  "blocked"};

template <class Enum, std::size_t count>
std::optional<Enum> named(const std::array<std::string_view, count>& names, const std::string& word) {
    const auto found = std::ranges::find(names, word);
    if (found == names.end()) return std::nullopt;
    return static_cast<Enum>(found - names.begin());
}

}  // namespace

bool was_cast(const RayNode& node) {
    return node.ended != Ending::depth && node.ended != Ending::threshold && node.ended != Ending::roulette &&
           node.ended != Ending::total_internal_reflection;
}

std::vector<std::vector<std::size_t>> children(const RayTree& tree) {
    std::vector<std::vector<std::size_t>> result(tree.nodes.size());
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        if (tree.nodes[i].parent != RayNode::none) result[tree.nodes[i].parent].push_back(i);
    return result;
}

std::string to_string(RayKind kind) { return std::string(kinds[static_cast<std::size_t>(kind)]); }
std::string to_string(Ending ending) { return std::string(endings[static_cast<std::size_t>(ending)]); }

std::optional<RayKind> ray_kind(const std::string& word) { return named<RayKind>(kinds, word); }
std::optional<Ending> ending(const std::string& word) { return named<Ending>(endings, word); }

}  // namespace raylab
