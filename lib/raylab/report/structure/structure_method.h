#pragma once

#include "raylab/accelerator/accelerator.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace raylab {

/// One of the structures that a chapter compares: how it is called and made. What `accelerator_names()` has is exact; a
/// chapter adds its knobs ("grid, density 4") and its weak methods, whose boxes are floats without a bound.
struct StructureMethod {
    std::string name;
    std::string number = "exact";  // what its decisions are computed in
    std::function<std::unique_ptr<Accelerator>(const Scene&)> make;
};

/// The lab's own, by name.
StructureMethod structure_method(const std::string& name);
std::vector<StructureMethod> structure_methods(const std::vector<std::string>& names);

}  // namespace raylab
