#pragma once

#include "raylab/accelerator/accelerator.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace raylab {

/// One of the structures that a chapter compares: its name and how it is built. Those of `accelerator_names()` are
/// exact; a chapter adds settings of them ("grid, density 4") and weak methods, whose boxes are floats without an error
/// bound.
struct StructureMethod {
    std::string name;
    std::string number = "exact";  // the number type of its decisions
    std::function<std::unique_ptr<Accelerator>(const Scene&)> make;
};

/// One of the lab's own structures, by name.
StructureMethod structure_method(const std::string& name);
std::vector<StructureMethod> structure_methods(const std::vector<std::string>& names);

}  // namespace raylab
