#include "octree_methods.h"

#include "octree_kinds.h"
#include "octree_workloads.h"

#include "raylab/experiment/structure/structure_question.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace raylab::octrees {

namespace {

// A point further along the ray by `length`.
Vec3d along(const OctreeCube& cube, double length, const Vec3d& origin, const Vec3d& direction) {
    return origin + (exit_of(cube, origin, direction) + length / glm::length(direction)) * direction;
}

Vec3d fixed_step(const OctreeCube& cube, double, const Vec3d& origin, const Vec3d& direction) {
    return along(cube, 0.01 * Lattice::side, origin, direction);
}

Vec3d half_on(const OctreeCube& cube, double, const Vec3d& origin, const Vec3d& direction) {
    return along(cube, 0.5 * cube.side, origin, direction);
}

// A point beyond the face; along the other axes it is the rounded point, even outside the cube.
Vec3d not_held(const OctreeCube& cube, double smallest, const Vec3d& origin, const Vec3d& direction) {
    const Vec3d exit = origin + exit_of(cube, origin, direction) * direction;
    Vec3d point = point_in_next_cell(cube, smallest, origin, direction);
    for (int axis = 0; axis < 3; ++axis)
        if (point[axis] >= cube.low[axis] && point[axis] < cube.low[axis] + cube.side) point[axis] = exit[axis];
    return point;
}

// A point further by a hundredth of the smallest cell, rounded to floats at each step.
Vec3d small_step(const OctreeCube& cube, double smallest, const Vec3d& origin, const Vec3d& direction) {
    const Vec3f o = convert<float>(origin), d = convert<float>(direction);
    const float t = cast<float>(exit_of(cube, convert<double>(o), convert<double>(d)));
    const float on = cast<float>(0.01 * smallest) / glm::length(d);
    return convert<double>(o + (t + on) * d);
}

// The cost of a structure for the hall's rays.
std::vector<std::string> cost_row(const StructureMethod& method, const Scene& scene, const StructureWorkload& rays) {
    const auto structure = method.make(scene);
    Traversal traversal;
    answers_of(*structure, rays, traversal);
    const auto share = [](std::size_t count, std::size_t of) {
        return fmt::format("{:.1f}", static_cast<double>(count) / static_cast<double>(of));
    };
    const auto each = [&](std::uint64_t count) { return share(count, rays.rays.size()); };
    std::size_t leaves = 0, references = 0, triangles = 0;
    for (const auto& node : structure->outline().nodes) {
        leaves += node.children.empty() ? 1 : 0;
        references += node.primitives.size();
    }
    for (const Object& object : scene.objects)
        triangles += std::get<std::shared_ptr<const Mesh>>(object.shape)->faces.size();
    return {method.name, std::to_string(leaves), share(references, triangles), each(traversal.primitive_tests),
            each(traversal.steps)};
}

std::vector<std::vector<std::string>> cost_rows(const std::vector<StructureMethod>& methods, const ChapterRun& run) {
    const auto scene = hall(run.sized(5, 4));
    const auto rays = camera_rays("hall", scene, run.sized<std::size_t>(20'000, 2'000));
    std::vector<std::vector<std::string>> rows;
    for (const auto& method : methods) rows.push_back(cost_row(method, *scene, rays));
    return rows;
}

}  // namespace

std::vector<StructureMethod> exact_ways() {
    return structure_methods({"octree", "octree_point", "octree_hash", "octree_seads"});
}

std::vector<StructureMethod> ways(const ChapterRun& run) {
    std::vector<StructureMethod> methods{
        textbook("half a cell along the ray", "double", half_on),
        textbook("a fixed step along the ray", "double", fixed_step),
        textbook("a small step along the ray", "float", small_step),
        textbook("beyond the face, not held", "double", not_held),
        textbook("ends at any hit", "double", point_in_next_cell, TextbookOctree::End::at_first_hit),
        textbook(run.name_of("point_in_next_cell", "beyond the face"), "double", point_in_next_cell)};
    for (auto& method : exact_ways()) methods.push_back(std::move(method));
    return methods;
}

StructureMethod way(const std::string& name, const ChapterRun& run) {
    const auto all = ways(run);
    return *std::ranges::find(all, name, &StructureMethod::name);
}

Experiment measure_octrees(const ChapterRun& run) {
    const auto rays = run.sized<std::size_t>(10'000, 200);
    const auto scene = hall(run.sized(5, 4));
    const std::vector workloads{camera_rays("hall", scene, rays), incoherent_rays("hall", scene, rays, run.seed),
                                dust_rays(2, rays, run.seed), dust_rays(far_away, rays, run.seed),
                                plane_rays(rays, run.seed)};
    Experiment experiment =
        measure_structures(ways(run), workloads, {.repeats = run.sized(5, 3), .shortest = run.sized(0.002, 0.0002)});
    experiment.question = "octree_next_cell";
    experiment.title = "Where does a ray go on?";
    return experiment;
}

std::vector<std::string> leaf_header() {
    return {"a cell is a leaf", "leaves", "references a triangle", "tests a ray", "steps a ray"};
}

std::vector<std::vector<std::string>> leaf_rows(const ChapterRun& run) {
    using Cut = OctreeLimits::Cut;
    using Assign = OctreeLimits::Assign;
    return cost_rows({octree_by_points("with 1, or 5 cuts deep", {.few = 1, .depth = 5, .cut = Cut::always}),
                      octree_by_points("with 1, or 7 cuts deep", {.few = 1, .depth = 7, .cut = Cut::always}),
                      octree_by_points("with 16, or 7 cuts deep", {.few = 16, .depth = 7, .cut = Cut::always}),
                      octree_by_points("with 16, or where cutting does not pay", {}),
                      octree_by_points("the same, filled by boxes", {.assign = Assign::by_box}),
                      octree_by_points("with 1, or where cutting does not pay", {.few = 1}),
                      octree_by_points("with 64, or where cutting does not pay", {.few = 64})},
                     run);
}

std::vector<std::string> way_header() {
    auto header = leaf_header();
    header[0] = "the next cell";
    return header;
}

std::vector<std::vector<std::string>> way_rows(const ChapterRun& run) {
    const auto seads = [](std::uint32_t largest, int bits) {
        return OctreeLimits{.few = 4, .seads = {.largest = largest, .bits = bits}};
    };
    return cost_rows({octree_by_points("by a point, up and down", {}), octree_by_names("by name", {}),
                      octree_by_times("by times alone", {}), octree_by_blocks("by 3D-DDA, blocks of 2 x 2 x 2", {}),
                      octree_by_blocks("... and of 4 x 4 x 4 in its leaves", seads(64, 2)),
                      octree_by_blocks("... and of 8 x 8 x 8", seads(512, 3)),
                      octree_by_blocks("... and of 16 x 16 x 16", seads(4096, 4))},
                     run);
}

}  // namespace raylab::octrees
