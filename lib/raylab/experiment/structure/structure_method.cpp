#include "raylab/experiment/structure/structure_method.h"

namespace raylab {

StructureMethod structure_method(const std::string& name) {
    return {.name = name, .make = [name](const Scene& scene) { return make_accelerator(name, scene); }};
}

std::vector<StructureMethod> structure_methods(const std::vector<std::string>& names) {
    std::vector<StructureMethod> methods;
    for (const std::string& name : names) methods.push_back(structure_method(name));
    return methods;
}

}  // namespace raylab
