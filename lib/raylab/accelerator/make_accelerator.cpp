#include "raylab/accelerator/aabb_tree.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/list.h"
#include "raylab/base/error.h"

namespace raylab {

namespace {

// A dozen primitives are tested sooner than a tree is walked.
constexpr std::size_t longest_list = 12;

}  // namespace

std::unique_ptr<Accelerator> make_accelerator(const std::string& name, const Scene& scene) {
    if (name == "list") return std::make_unique<List>(scene);
    if (name == "aabb_tree") return std::make_unique<AabbTree>(scene);
    if (name != "auto") throw Error("expected an accelerator (auto, list, aabb_tree), found \"" + name + "\"");
    return make_accelerator(Primitives(scene).size() <= longest_list ? "list" : "aabb_tree", scene);
}

}  // namespace raylab
