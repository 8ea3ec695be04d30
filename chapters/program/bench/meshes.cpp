#include "meshes.h"

#include "raylab/base/error.h"
#include "raylab/experiment/generate/architecture.h"
#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/generate/uneven.h"
#include "raylab/geometry/bounds/box.h"
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
    const char* kind;
    Mesh (*made)(int levels);
};

constexpr Family families[] = {
    {"bumpy", 0, 8, "generated", [](int levels) { return bumpy_sphere(levels); }},
    {"knot", 4, 10, "generated", [](int levels) { return trefoil_knot(0.5, levels); }},
    {"torus", 2, 10, "generated", [](int levels) { return torus(0.4, levels); }},
    {"hair", 0, 14, "generated", hair},
    {"stadium", 0, 8, "generated", stadium},
    {"hall", 0, 10, "architecture", arcade_hall},
    {"city", 0, 7, "architecture", city},
};

struct Level {
    const Family* family;
    int levels;
};

std::optional<Level> level_named(const std::string& name) {
    for (const Family& family : families)
        for (int levels = family.fewest; levels <= family.largest; ++levels)
            if (name == family.name + std::string("_") + std::to_string(levels)) return Level{&family, levels};
    return std::nullopt;
}

bool is_inside(const std::string& name) { return name.starts_with("hall_"); }

// A point inside a box or near it: each coordinate from 0 to 1 along an edge.
Vec3d place_in(const Box& box, const Vec3d& part) {
    return convert<double>(box.min) + part * (convert<double>(box.max) - convert<double>(box.min));
}

// What stands on all sides is seen from inside; anything else from as far away as it is large.
void add_view(Scene& scene, const std::string& name) {
    const Box box = *bounds(scene.objects.at(0).shape);
    if (is_inside(name)) {
        scene.camera = {.position = place_in(box, {0.02, 0.3, 0.4}), .target = place_in(box, {1, 0.35, 0.6})};
        scene.lights.push_back({PointLight{place_in(box, {0.4, 0.8, 0.5})}});
        return;
    }
    const double diagonal = glm::length(convert<double>(box.max) - convert<double>(box.min));
    const Vec3d view = glm::normalize(Vec3d{0.5, 0.35, 1});
    scene.camera = {.position = box.center() + diagonal * view, .target = box.center()};
    scene.lights.push_back({PointLight{box.center() + diagonal * Vec3d{-0.8, 1.2, 0.6}}});
}

/// A function that generates or reads the mesh when it is called.
std::function<Mesh()> maker(const std::string& name) {
    const auto real = demo_mesh_names();
    if (std::ranges::find(real, name) != real.end()) {
        if (const auto path = demo_mesh(name)) return [path] { return read_mesh(*path); };
        throw Error("the mesh " + name +
                    " has not been fetched; expected cmake/fetch_meshes.sh build/meshes to have run");
    }
    if (const auto level = level_named(name)) return [level] { return level->family->made(level->levels); };
    if (name.find('.') == std::string::npos)
        throw Error(fmt::format("expected a mesh ({}, {}, or a file), found \"{}\"", fmt::join(real, ", "),
                                mesh_families(), name));
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
    add_view(scene, name);
    return scene;
}

void refuse_unknown_mesh(const std::string& name) { maker(name); }

std::vector<std::string> usual_meshes() {
    std::vector<std::string> names;
    for (const char* name : {"elephant_coarse", "dragon", "armadillo", "bunny", "elephant"})
        if (demo_mesh(name)) names.push_back(name);
    // From 67 704 triangles (hall_4) to 1 310 720 (bumpy_8).
    names.insert(names.end(), {"hall_4", "city_3", "knot_8", "bumpy_8", "hair_7", "stadium_6"});
    return names;
}

std::string mesh_families() {
    std::vector<std::string> texts;
    for (const Family& family : families)
        texts.push_back(fmt::format("{0}_{1} to {0}_{2}", family.name, family.fewest, family.largest));
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string kind_of_mesh(const std::string& name) {
    if (const auto level = level_named(name)) return level->family->kind;
    const auto real = demo_mesh_names();
    return std::ranges::find(real, name) != real.end() ? "scans" : "files";
}

const Mesh& mesh_of(const Scene& scene) { return *std::get<std::shared_ptr<const Mesh>>(scene.objects.at(0).shape); }

}  // namespace raylab::bench
