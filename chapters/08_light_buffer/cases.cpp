#include "cases.h"

#include "light_methods.h"

#include "raylab/report/decision_trial.h"
#include "raylab/report/structure/structure_trial.h"
#include "raylab/sampling/sequence.h"

#include <fmt/format.h>

namespace raylab::lantern {

namespace {

StructureMethod cells(Listing listing, int resolution, const ChapterRun& run) {
    StructureMethod method = light_buffer(listing, resolution, run);
    method.name += fmt::format(", {0} x {0}", resolution);
    return method;
}

// A buffer whose cells a student's light_cell() finds is shown, but nothing is expected of it.
CaseRow never_wrong(const StructureTrial& trial, Listing listing, int resolution, const ChapterRun& run) {
    const StructureMethod method = cells(listing, resolution, run);
    return run.is_yours("light_cell") ? trial.shown(method) : trial.never_wrong(method);
}

CaseRow conservative(const StructureTrial& trial, int resolution, const ChapterRun& run) {
    return never_wrong(trial, Listing::conservative, resolution, run);
}

std::size_t rays(const ChapterRun& run) { return run.sized<std::size_t>(100'000, 3'000); }

// Shadow rays to a light at the origin along borders of cells, edges of the cube and its diagonals.
StructureWorkload along_borders(int resolution, const ChapterRun& run) {
    StructureWorkload workload = among_triangles("cells' borders, cube's edges", 300, 0.4, 0, run.seed);
    for (std::size_t i = 0; i < rays(run); ++i) {
        RandomSequence random(run.seed + 7, i);
        Vec3d way = random.in_cube();
        const auto border = [&] { return 2.0 * random.whole(0, resolution) / resolution - 1; };
        const int axis = random.whole(0, 2);
        way[axis] = random.next() < 0.5 ? -1 : 1;
        way[(axis + 1) % 3] = border();
        if (random.next() < 0.5) way[(axis + 2) % 3] = border();
        workload.rays.push_back(shadow_ray_from(way * (0.1 + 2 * random.next()), {0, 0, 0}));
    }
    return workload;
}

std::vector<CaseRow> light_cell_rows(const ChapterRun& run) {
    const StructureTrial borders(along_borders(16, run));
    const StructureTrial small(among_triangles("smaller than a cell", 1000, 0.05, rays(run), run.seed));
    const StructureTrial large(among_triangles("beside and behind the light", 10, 4, rays(run), run.seed));
    std::vector<CaseRow> rows;
    for (const StructureTrial* trial : {&borders, &small, &large})
        for (const int resolution : {1, 16, 128}) rows.push_back(conservative(*trial, resolution, run));
    rows.push_back(never_wrong(borders, Listing::rectangles, 16, run));
    rows.push_back(never_wrong(large, Listing::rectangles, 16, run));
    rows.push_back(small.more_wrong_than(0.01, cells(Listing::centers, 16, run)));
    return rows;
}

// A light in a closed box that stands in the open, in a ball, and on a floor from whose points it is seen edge-on.
std::vector<CaseRow> light_inside_rows(const ChapterRun& run) {
    const auto asked = [&](const std::string& name, const std::vector<Shape>& shapes, const Vec3d& light) {
        StructureWorkload workload = among_triangles(name, 40, 0.8, 0, run.seed);
        auto scene = std::make_shared<Scene>(*workload.scene);
        for (const Shape& shape : shapes) scene->objects.push_back({.shape = shape});
        scene->lights[0].kind = PointLight{light};
        workload.scene = scene;
        for (std::size_t i = 0; i < rays(run); ++i) {
            RandomSequence random(run.seed + 3, i);
            Vec3d from = 2.0 * random.in_cube();
            if (random.next() < 0.3) from.y = light.y;
            workload.rays.push_back(shadow_ray_from(from, light));
        }
        return StructureTrial(std::move(workload));
    };
    const auto wall = [](int axis, float at) {
        Polygon polygon{{Vec3f(-0.5f), Vec3f(-0.5f), Vec3f(-0.5f), Vec3f(-0.5f)}};
        for (Vec3f& v : polygon.vertices) v[axis] = at;
        for (const std::size_t i : {1u, 2u}) polygon.vertices[i][(axis + 1) % 3] = 0.5f;
        for (const std::size_t i : {2u, 3u}) polygon.vertices[i][(axis + 2) % 3] = 0.5f;
        return Shape(polygon);
    };
    const std::vector<Shape> box{wall(0, -0.5f), wall(0, 0.5f),  wall(1, -0.5f),
                                 wall(1, 0.5f),  wall(2, -0.5f), wall(2, 0.5f)};
    const StructureTrial in_box = asked("in a box", box, {0.1, 0.2, -0.1}),
                         in_corner = asked("in a corner of the box", box, {0.5, 0.5, 0.5}),
                         in_ball = asked("in a ball", {Sphere{{0, 0, 0}, 0.7f}}, {0, 0.1, 0}),
                         on_floor = asked("on a floor", {Polygon{{{-3, -1, -3}, {3, -1, -3}, {3, -1, 3}, {-3, -1, 3}}}},
                                          {0.25, -1, 0.5});
    std::vector<CaseRow> rows;
    for (const StructureTrial* trial : {&in_box, &in_corner, &in_ball, &on_floor})
        for (const int resolution : {4, 64}) rows.push_back(conservative(*trial, resolution, run));
    return rows;
}

// A buffer belongs to one position of the light: shadow rays to another position are none of its rays, and it says so.
std::vector<CaseRow> light_moved_rows(const ChapterRun& run) {
    StructureWorkload workload = among_triangles("the light moved by 0.01", 300, 0.3, rays(run) / 4, run.seed);
    const Scene before = *workload.scene;
    for (Ray& ray : workload.rays) ray = shadow_ray_from(convert<double>(ray.origin), {0.01, 0, 0});
    const StructureTrial trial(std::move(workload));
    const LightBuffer buffer(before, {0, 0, 0});
    std::size_t known = 0;
    for (const Ray& ray : trial.workload().rays) {
        Traversal traversal;
        known += buffer.occluded(ray, traversal).has_value();
    }
    const double share = static_cast<double>(known) / static_cast<double>(trial.workload().rays.size());
    return {{row_title("the old buffer", trial.workload().name), "holds: says that it does not know",
             share_text(share) + " of rays taken for its own", share == 0},
            conservative(trial, 32, run)};
}

}  // namespace

std::vector<StabilityCase> cases(const ChapterRun& run) {
    const auto of = [&run](std::vector<CaseRow> (*rows)(const ChapterRun&)) {
        return [run, rows] { return rows(run); };
    };
    return {{"LIGHT-CELL",
             "Shadow rays in the borders of cells and edges of the cube; occluders smaller than a cell, beside and "
             "behind the light.",
             of(light_cell_rows)},
            {"LIGHT-INSIDE", "A light in a closed box, in its corner, in a ball, on a floor that is looked at edge-on.",
             of(light_inside_rows)},
            {"LIGHT-MOVED", "A light that has moved away from its buffer.", of(light_moved_rows)}};
}

}  // namespace raylab::lantern
