#include "cell_sizes.h"

#include "grid_facts.h"

#include "raylab/experiment/generate/generate.h"
#include "raylab/experiment/structure/structure_question.h"
#include "raylab/image/picture_files/files.h"
#include "raylab/report/chart/chart.h"
#include "raylab/report/structure/structure_drawing.h"
#include "raylab/report/table.h"
#include "raylab/sampling/random.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace raylab::grids {

namespace {

std::shared_ptr<const Scene> shared(Scene scene) { return std::make_shared<const Scene>(std::move(scene)); }

std::shared_ptr<const Scene> knot(int levels) {
    return shared(mesh_scene(std::make_shared<const Mesh>(trefoil_knot(0.5, levels)), "knot"));
}

struct Swept {
    std::string scene;
    std::vector<double> densities;
    std::vector<Measurement> rows;
};

Swept swept(const std::string& name, const std::shared_ptr<const Scene>& scene, const ChapterRun& run) {
    Swept result{name, {}, {}};
    const auto workload = camera_rays(name, scene, run.sized<std::size_t>(2'500, 400));
    const auto truth = true_answers(workload);
    for (const double density : {0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0}) {
        result.densities.push_back(density);
        result.rows.push_back(measure_structure(structure_method(fmt::format("grid:{:g}", density)), workload, truth,
                                                {.repeats = run.sized(3, 1), .shortest = 0}));
    }
    return result;
}

std::vector<Page::Figure> charted(const std::vector<Swept>& all, const ChapterRun& run) {
    struct Shown {
        const char *name, *label, *caption;
        double (*value)(const Measurement&);
    };
    const std::vector<Shown> shown{
        {"density_tests", "primitive tests a ray", "Smaller cells hold less ...",
         [](const Measurement& m) { return m.counts.at("primitive tests"); }},
        {"density_steps", "cells a ray",
         "... but there are more of them on the way, twice as many for eight times "
         "the cells.",
         [](const Measurement& m) { return m.counts.at("steps"); }},
        {"density_time", "microseconds a ray", "The sum: flat over a factor of ten, and then not.",
         [](const Measurement& m) { return 1e-3 * m.nanoseconds.median; }},
        {"density_bytes", "bytes a primitive", "Memory only grows.",
         [](const Measurement& m) { return m.counts.at("bytes a primitive"); }}};
    std::vector<Page::Figure> figures;
    for (const auto& [name, label, caption, value] : shown) {
        CurveChart chart{.title = label,
                         .x_label = "cells a primitive",
                         .y_label = label,
                         .x_axis = AxisKind::logarithmic,
                         .y_axis = AxisKind::logarithmic,
                         .curves = {}};
        for (const Swept& sweep : all) {
            Curve curve{.name = sweep.scene, .x = sweep.densities, .y = {}};
            for (const Measurement& row : sweep.rows) curve.y.push_back(value(row));
            chart.curves.push_back(curve);
        }
        for (const auto& file : write_chart(chart, run.out, name))
            if (file.extension() == ".svg") figures.push_back({file.filename().string(), caption});
    }
    return figures;
}

// Small spheres at random places in a cube, the ideal scene for grids.
Scene even_balls(int count, std::uint64_t seed) {
    Scene scene;
    for (int i = 0; i < count; ++i) {
        const auto at = [&](std::uint64_t dimension) {
            return cast<float>(
                2 * random_number({.seed = seed, .pixel = static_cast<std::uint64_t>(i), .dimension = dimension}) - 1);
        };
        scene.objects.push_back(
            {.shape = Sphere{{at(0), at(1), at(2)}, 0.3f / std::cbrt(static_cast<float>(count))}, .placement = {}});
    }
    look_at_all(scene);
    return scene;
}

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

CostPerRay cost_per_ray(const std::string& accelerator, const StructureWorkload& workload) {
    Traversal traversal;
    answers_of(*make_accelerator(accelerator, *workload.scene), workload, traversal);
    const auto rays = static_cast<double>(workload.rays.size());
    return {static_cast<double>(traversal.primitive_tests) / rays, static_cast<double>(traversal.box_tests) / rays,
            static_cast<double>(traversal.steps) / rays};
}

void tell_cell_sizes(const ChapterRun& run, Page& page) {
    page.heading("How large is a cell?");
    page.text("Large cells hold many things, and each is tested. Small cells are many, and each is visited, and "
              "holds what its neighbours hold. The usual rule makes the number of cells a multiple of the number of "
              "primitives, the *density*.");
    const int levels = run.sized(6, 4);
    const std::vector<Swept> all{swept("even balls", shared(even_balls(run.sized(8000, 500), run.seed)), run),
                                 swept("knot", knot(levels), run),
                                 swept("knot in a stadium", shared(knot_in_stadium(levels, 50)), run)};
    page.figures(charted(all, run));
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < all[0].densities.size(); ++i) {
        rows.push_back({number_text(all[0].densities[i])});
        for (const Swept& sweep : all)
            rows.back().push_back(number_text(sweep.rows[i].counts.at("primitive tests")) + " / " +
                                  number_text(sweep.rows[i].counts.at("steps")));
    }
    page.table({"cells a primitive", all[0].scene, all[1].scene, all[2].scene}, rows,
               "Tests / cells a ray of the camera.");
}

void tell_mailboxes(const ChapterRun& run, Page& page) {
    page.heading("Met before");
    page.text("What lies in several cells is tested in each of them, unless the ray remembers. The id of the last "
              "ray on every primitive is a perfect memory; the last eight primitives of the ray in a small cache "
              "are a short one.");
    std::vector<std::vector<std::string>> rows;
    for (const double density : {1.0, 8.0, 64.0}) {
        const auto workload =
            incoherent_rays("knot", knot(run.sized(6, 4)), run.sized<std::size_t>(4'000, 400), run.seed);
        rows.push_back({number_text(density)});
        for (const StructureMethod& method :
             {structure_method(fmt::format("grid:{:g}", density)),
              structure_method(fmt::format("grid_mailbox:{:g}", density)), cached_grid(density)}) {
            Traversal traversal;
            answers_of(*method.make(*workload.scene), workload, traversal);
            rows.back().push_back(number_text(static_cast<double>(traversal.primitive_tests) /
                                              static_cast<double>(workload.rays.size())));
        }
    }
    page.table({"cells a primitive", "no mailboxes", "id of the ray", "cache of eight"}, rows,
               "Primitive tests an incoherent ray.");
}

void tell_stadium(const ChapterRun& run, Page& page) {
    page.heading("A teapot in a stadium");
    const auto scene = shared(knot_in_stadium(run.sized(6, 4), 50));
    const GridFacts grid = grid_facts(*scene);
    page.text("Cells are of one size everywhere. Where all detail is in one corner, a thousandth of the cells holds "
              "it, and a finer grid spends its cells on air. (E. Haines named it; here a knot stands in for the "
              "pot.)");
    StructureView view{.title = "from above: each square a cell that holds something", .along = 1};
    page.figures({{write_picture(to_image(draw_structure(*scene, make_accelerator("grid", *scene)->outline(), view)),
                                 run.out, "stadium"),
                   fmt::format("{} triangles, {} cells. All triangles but those of the stadium are in the dark ones "
                               "in the middle.",
                               number_text(static_cast<double>(grid.primitives)),
                               number_text(static_cast<double>(grid.cells)))}});
    const auto workload = camera_rays("stadium", scene, run.sized<std::size_t>(2'500, 400));
    std::vector<std::vector<std::string>> rows;
    for (const std::string name : {"grid:1", "grid:8", "grid:64", "grid_mailbox:64", "bvh"}) {
        const CostPerRay cost = cost_per_ray(name, workload);
        rows.push_back({name, number_text(cost.tests), number_text(cost.steps), number_text(cost.box_tests)});
    }
    page.table({"structure", "primitive tests", "steps", "box tests"}, rows,
               "A ray of the camera, which sees the knot.");
}

}  // namespace raylab::grids
