#include "meshes.h"

#include "raylab/base/error.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/scene/demo_meshes.h"
#include "raylab/scene/mesh/read_mesh.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>

namespace raylab::bench {

namespace {

struct Family {
    const char* name;
    int fewest, largest;  // levels
    Mesh (*made)(int levels);
};

constexpr Family families[] = {{"bumpy", 0, 8, [](int levels) { return bumpy_sphere(levels); }},
                               {"knot", 4, 10, [](int levels) { return trefoil_knot(0.5, levels); }},
                               {"torus", 2, 10, [](int levels) { return torus(0.4, levels); }}};

std::optional<std::function<Mesh()>> generator(const std::string& name) {
    for (const Family& family : families)
        for (int levels = family.fewest; levels <= family.largest; ++levels)
            if (name == family.name + std::string("_") + std::to_string(levels))
                return [&family, levels] { return family.made(levels); };
    return std::nullopt;
}

/// A function that generates or reads the mesh when it is called.
std::function<Mesh()> maker(const std::string& name) {
    const auto real = demo_mesh_names();
    if (std::ranges::find(real, name) != real.end()) {
        if (const auto path = demo_mesh(name)) return [path] { return read_mesh(*path); };
        throw Error("the mesh " + name +
                    " has not been fetched; expected cmake/fetch_meshes.sh build/meshes to have run");
    }
    if (auto made = generator(name)) return *made;
    if (name.find('.') == std::string::npos)
        throw Error(fmt::format("expected a mesh ({}, bumpy_0 to bumpy_8, knot_4 to knot_10, torus_2 to torus_10, or a "
                                "file), found \"{}\"",
                                fmt::join(real, ", "), name));
    if (!std::filesystem::exists(name)) throw Error({name}, "a mesh file", "nothing there");
    return [name] { return read_mesh(name); };
}

}  // namespace

Scene scene_of_mesh(const std::string& name) {
    Mesh found = maker(name)();
    if (found.faces.empty()) throw Error(name + ": expected a mesh with triangles, found none");
    found.vertices.reserve(found.vertices.size() + 1);  // Embree reads sixteen bytes where the last vertex has twelve
    Scene scene;
    scene.objects.push_back({.shape = std::make_shared<const Mesh>(std::move(found))});
    return scene;
}

void refuse_unknown_mesh(const std::string& name) { maker(name); }

std::vector<std::string> usual_meshes() {
    std::vector<std::string> names;
    for (const char* name : {"elephant_coarse", "dragon", "armadillo", "bunny", "elephant"})
        if (demo_mesh(name)) names.push_back(name);
    names.insert(names.end(), {"knot_8", "bumpy_8"});  // 131 072 and 1 310 720 triangles
    return names;
}

const Mesh& mesh_of(const Scene& scene) { return *std::get<std::shared_ptr<const Mesh>>(scene.objects.at(0).shape); }

}  // namespace raylab::bench
