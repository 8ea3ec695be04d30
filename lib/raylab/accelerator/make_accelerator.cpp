#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/list.h"
#include "raylab/base/error.h"

namespace raylab {

std::unique_ptr<Accelerator> make_accelerator(const std::string& name, const Scene& scene) {
    if (name == "list") return std::make_unique<List>(scene);
    throw Error("expected an accelerator (list), found \"" + name + "\"");
}

}  // namespace raylab
