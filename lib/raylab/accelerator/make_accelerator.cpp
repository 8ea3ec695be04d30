#include "raylab/accelerator/aabb_tree.h"
#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/boxed_list.h"
#include "raylab/accelerator/list.h"
#include "raylab/base/error.h"
#include "raylab/scene/needs.h"

namespace raylab {

std::unique_ptr<Accelerator> make_accelerator(const std::string& name, const Scene& scene) {
    if (name == "list") return std::make_unique<List>(scene);
    if (name == "boxed_list") return std::make_unique<BoxedList>(scene);
    if (name == "aabb_tree") return std::make_unique<AabbTree>(scene);
    if (name != "auto") throw Error("expected an accelerator (auto, list, boxed_list, aabb_tree), found \"" + name + "\"");
    return make_accelerator(suited_accelerator(scene), scene);
}

}  // namespace raylab
