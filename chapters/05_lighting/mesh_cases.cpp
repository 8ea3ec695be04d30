#include "cases.h"

#include "mach_bands.h"
#include "shaded_mesh.h"
#include "surfaces.h"

#include "raylab/geometry/mesh/vertex_normals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raylab::lighting {

namespace {

double shade(const std::string& title, const ShadedMesh& mesh, const MeshPoint& point) {
    double answer = 0;
    find_method(shading_methods(), title).answer({}, std::span(&mesh, 1), std::span(&point, 1), std::span(&answer, 1));
    return answer;
}

StabilityCase mach_bands() {
    return {
        "MACH-BANDS",
        "Brightness along a line across a sphere of 320 triangles: its largest step, and its largest change of slope.",
        [] {
            const auto found = roughness_along_line();
            const auto& flat = found[0];
            const auto& gouraud = found[1];
            const auto& phong = found[2];
            return std::vector<CaseRow>{{flat.method, "fails: steps by more than 0.03",
                                         fmt::format("steps by {:.2g}", flat.jump), flat.jump > 0.03},
                                        {gouraud.method, "fails: no step, but kinks of more than 5e-4",
                                         fmt::format("steps by {:.1g}, kinks of {:.1g}", gouraud.jump, gouraud.kink),
                                         gouraud.jump < 0.01 && gouraud.kink > 5e-4},
                                        {phong.method, "holds: no step, and kinks less than half of Gouraud's",
                                         fmt::format("steps by {:.1g}, kinks of {:.1g}", phong.jump, phong.kink),
                                         phong.jump < 0.01 && phong.kink < gouraud.kink / 2}};
        }};
}

// A triangle that approximates a part of a sphere about the origin, with the highlight in its middle.
ShadedMesh triangle_with_highlight(double shininess) {
    ShadedMesh shaded{.mesh = {.vertices = {{0.3117691f, 0.18f, 0.9f}, {-0.3117691f, 0.18f, 0.9f}, {0, -0.36f, 0.9f}},
                               .faces = {{0, 1, 2}}},
                      .lighting = {.to_light = {0, 0, 1},
                                   .to_viewer = {0, 0, 1},
                                   .ambient = 0,
                                   .diffuse = 0,
                                   .specular = 1,
                                   .shininess = shininess}};
    for (const auto& v : shaded.mesh.vertices)
        shaded.mesh.normals.push_back(convert<float>(glm::normalize(convert<double>(v))));
    return shaded;
}

CaseRow highlight_row(const std::string& title, double shininess, double smallest, double largest) {
    const double seen = shade(title, triangle_with_highlight(shininess), {0, 1 / 3.0, 1 / 3.0});
    return {title,
            smallest > 0.5 ? fmt::format("holds: more than {:g} of it", smallest)
                           : fmt::format("fails: less than {:g} of it", largest),
            fmt::format("{:.3g} of it", seen), seen >= smallest && seen <= largest};
}

StabilityCase lost_highlight() {
    return {"LOST-HIGHLIGHT", "A highlight in the middle of a triangle, which its corners do not see.", [] {
                return std::vector{highlight_row("Gouraud, double", 100, 0, 1e-3),
                                   highlight_row("Phong, double", 100, 0.99, 1.001)};
            }};
}

StabilityCase normal_left_short() {
    return {"NORMAL-LEFT-SHORT",
            "The same highlight by a mixed normal, which is shorter than its parts, and by one made unit again.", [] {
                return std::vector{highlight_row("Phong, not unit again, double", 100, 0, 0.01),
                                   highlight_row("Phong, double", 100, 0.99, 1.001)};
            }};
}

// Two triangles back to back, as leaves are modelled.
StabilityCase leaf() {
    return {"LEAF", "Two triangles back to back that share their vertices: the normals of a vertex cancel.", [] {
                const Mesh mesh{.vertices = {{0, 0, 0}, {0.9f, 0.1f, 0.2f}, {0.3f, 0.8f, 0.1f}},
                                .faces = {{0, 1, 2}, {0, 2, 1}}};
                const Vec3f by_hand = glm::normalize(Vec3f{0, 0, 0});
                const auto normals = vertex_normals(mesh);
                const bool absent = std::ranges::all_of(normals, [](const Vec3f& n) { return n == Vec3f{0, 0, 0}; });
                return std::vector<CaseRow>{
                    {"the sum, made unit", "fails: not a number", std::isnan(by_hand.x) ? "not a number" : "a normal",
                     std::isnan(by_hand.x)},
                    {"the lab", "holds: no normal, the triangle's own stands in", absent ? "no normal" : "a normal",
                     absent}};
            }};
}

StabilityCase cube_corner() {
    return {"CUBE-CORNER",
            "The corner of a cube, whose faces are cut into two triangles, not all of them through the corner.", [] {
                const Mesh mesh{
                    .vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}},
                    .faces = {{0, 2, 1}, {0, 3, 2}, {0, 4, 5}, {0, 5, 3}, {0, 1, 4}, {1, 6, 4}}};
                const Vec3d truth = glm::normalize(Vec3d{-1, -1, -1});
                Vec3d sum{0, 0, 0};
                for (std::size_t i = 0; i + 1 < mesh.faces.size(); ++i) {  // the last one does not touch the corner
                    const auto [a, b, c] = in<double>(mesh.triangle(i));
                    sum += glm::normalize(cross(b - a, c - a));
                }
                const auto degrees = [&](const Vec3d& normal) {
                    return 180 / std::numbers::pi * std::acos(std::min(1.0, dot(truth, glm::normalize(normal))));
                };
                const double equal = degrees(sum), by_angle = degrees(convert<double>(vertex_normals(mesh)[0]));
                return std::vector<CaseRow>{{"every triangle counts alike", "fails: leans by more than 10 degrees",
                                             fmt::format("leans by {:.3g} degrees", equal), equal > 10},
                                            {"by the angle at the corner", "holds: does not lean",
                                             fmt::format("leans by {:.1g} degrees", by_angle), by_angle < 1e-3}};
            }};
}

StabilityCase three_points(const ChapterRun& run) {
    return {
        "THREE-POINTS",
        "The normal through three points of a surface, 1e-12 apart: nothing but rounding is left of their differences.",
        [run] {
            std::vector<CaseRow> rows;
            for (const auto& surface : two_way_surfaces()) {
                const double near = worst_lean_by_three_points(surface, 1e-12, run.seed);
                const double tangents = worst_lean(surface, surface.by_tangents, run.seed);
                rows.push_back({surface.name + ", three points", "fails: leans by more than 1e-6 rad",
                                fmt::format("leans by {:.1g} rad", near), near > 1e-6});
                rows.push_back({surface.name + ", tangents", "holds: within 1e-14 rad of the gradient",
                                fmt::format("within {:.1g} rad", tangents), tangents < 1e-14});
            }
            return rows;
        }};
}

}  // namespace

std::vector<StabilityCase> mesh_cases(const ChapterRun& run) {
    return {three_points(run), mach_bands(), lost_highlight(), normal_left_short(), leaf(), cube_corner()};
}

}  // namespace raylab::lighting
