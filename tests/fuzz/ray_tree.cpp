#include "raylab/report/json_text.h"
#include "raylab/report/ray_tree/ray_tree_diagram.h"
#include "raylab/report/ray_tree/ray_tree_json.h"
#include "raylab/report/ray_tree/ray_tree_words.h"

#include "fuzz/value_or_error.h"

#include <nlohmann/json.hpp>

#include <cassert>

using namespace raylab;

namespace {

// A tree that was read must not throw: noexcept ends the fuzzer if it does.
void check_tree(const RayTree& tree) noexcept {
    const std::string text = json_text(to_json(tree));
    assert(json_text(to_json(ray_tree_from_json(text, "fuzz"))) == text);
    ray_tree_diagram(tree, summary(tree), {.shadow_rays = RayTreeView::ShadowRays::shown});
}

}  // namespace

// Any bytes must give a ray tree that can be drawn, and is written and read again unchanged, or an Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return value_or_error(data, size, [](std::string_view bytes) { check_tree(ray_tree_from_json(bytes, "fuzz")); });
}
