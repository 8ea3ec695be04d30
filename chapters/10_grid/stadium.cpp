#include "stadium.h"

#include "cell_sizes.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/report/structure/structure_drawing.h"
#include "raylab/report/table.h"

#include <cmath>
#include <numbers>

namespace raylab::grids {

namespace {

// A field, and a wall of seats around it, made of large triangles.
std::vector<Object> stadium(float wide) {
    auto mesh = std::make_shared<Mesh>();
    constexpr int sectors = 24;
    for (const auto& [radius, height] : {std::pair{0.6f, 0.0f}, {0.6f, 0.05f}, {1.0f, 0.35f}})
        for (int i = 0; i < sectors; ++i) {
            const double angle = 2 * std::numbers::pi * i / sectors;
            mesh->vertices.push_back({wide * radius * static_cast<float>(std::cos(angle)), wide * height,
                                      wide * radius * static_cast<float>(std::sin(angle))});
        }
    const auto vertex = [](int ring, int i) { return static_cast<std::uint32_t>(ring * sectors + i % sectors); };
    for (int ring = 0; ring < 2; ++ring)
        for (int i = 0; i < sectors; ++i) {
            mesh->faces.push_back({vertex(ring, i), vertex(ring, i + 1), vertex(ring + 1, i)});
            mesh->faces.push_back({vertex(ring, i + 1), vertex(ring + 1, i + 1), vertex(ring + 1, i)});
        }
    for (int i = 1; i + 1 < sectors; ++i) mesh->faces.push_back({vertex(0, 0), vertex(0, i), vertex(0, i + 1)});
    return {{.shape = std::shared_ptr<const Mesh>(mesh), .placement = {}}};
}

}  // namespace

Scene knot_in_stadium(int levels, float wide) {
    Scene scene = mesh_scene(std::make_shared<const Mesh>(trefoil_knot(0.5, levels)), "knot");
    Scene result;
    result.camera = scene.camera;  // the camera of the knot alone, as if through binoculars
    result.lights = scene.lights;
    result.materials = scene.materials;
    result.objects = scene.objects;
    for (Object& object : result.objects) object.placement.translation = {0, 3.5f, 0};
    result.camera.position += Vec3d(0, 3.5, 0);
    result.camera.target += Vec3d(0, 3.5, 0);
    for (Object& object : stadium(4 * wide)) result.objects.push_back(std::move(object));
    return result;
}

std::shared_ptr<const Scene> stadium_scene(const ChapterRun& run) {
    return std::make_shared<const Scene>(knot_in_stadium(run.sized(6, 4), 50));
}

Image draw_stadium(const Scene& scene) {
    const Outline outline = make_accelerator("grid", scene)->outline();
    constexpr int along = 1, side = 480;
    constexpr float reach = 16;
    PlaneDrawing all = draw_structure(
        scene, outline, {.title = "cells that hold something", .along = along, .width = side, .height = side});
    PlaneDrawing middle = draw_structure(scene, outline,
                                         {.title = "the middle: the knot in four of them",
                                          .along = along,
                                          .shown = Box{Vec3f(-reach), Vec3f(reach)},
                                          .width = side,
                                          .height = side,
                                          .max_shapes = 20'000});
    all.marks.push_back(
        PlaneDrawing::Figure{PlanePolygon{{{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}}},
                             {.line = "#d55e00", .width = 3}});
    all.notes.clear();
    middle.notes.clear();
    return side_by_side({to_image(all), to_image(middle)}, 16);
}

std::vector<std::string> stadium_header() { return {"structure", "primitive tests", "steps", "box tests"}; }

std::vector<std::vector<std::string>> stadium_rows(const std::shared_ptr<const Scene>& scene, const ChapterRun& run) {
    const auto workload = camera_rays("stadium", scene, run.sized<std::size_t>(2'500, 400));
    std::vector<std::vector<std::string>> rows;
    for (const std::string name : {"grid:1", "grid:8", "grid:64", "grid_mailbox:64", "bvh"}) {
        const CostPerRay cost = cost_per_ray(name, workload);
        rows.push_back({name, number_text(cost.tests), number_text(cost.steps), number_text(cost.box_tests)});
    }
    return rows;
}

}  // namespace raylab::grids
