#include "tables.h"

#include "rooms.h"
#include "section.h"
#include "termination.h"

#include "raylab/report/provenance.h"
#include "raylab/scene/read_scene.h"
#include "raylab/tracer/refracted_direction.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace raylab::recursion {

namespace {

std::string share(const Endings& found, Ending ending) {
    return found.percent.contains(ending) ? fmt::format("{:.1f} %", found.percent.at(ending)) : "none";
}

std::string brightness(double rho, int depth) {
    return fmt::format("{:.6f}", hall_of_mirrors(rho).brightness({.depth = depth}));
}

}  // namespace

std::vector<std::string> ray_sum_header() {
    return {"ray", "kind", "what it hit", "throughput", "I_local: red, green, blue", "product"};
}

Rows ray_sum_rows(const Scene& scene, const RayTree& tree) {
    const auto words = [](const Color& c) { return fmt::format("{:.3f}, {:.3f}, {:.3f}", c.x, c.y, c.z); };
    Rows rows;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const RayNode& node = tree.nodes[i];
        if (node.kind == RayKind::shadow || !was_cast(node)) continue;
        rows.push_back({std::to_string(i + 1), to_string(node.kind), word_for(scene, node),
                        fmt::format("{:.4g}", node.throughput), words(node.local), words(node.contribution)});
    }
    rows.push_back({"", "", "", "", "the pixel", words(tree.pixel)});
    return rows;
}

Rows worked_refraction_rows() {
    const Scene scene = read_scene(source_folder() / "chapters/07_recursion/section.toml");
    const RayNode first = section_tree(scene).nodes[0];
    const Vec3d d = glm::normalize(convert<double>(first.ray.direction)), n = first.normal;
    const double c = -dot(d, n), eta = 1 / 1.5;
    const Vec3d along = d + c * n, a = eta * along;
    const auto row = [](const std::string& step, const Vec3d& v) -> std::vector<std::string> {
        return {step, fmt::format("{:.4f}", v.x), fmt::format("{:.4f}", v.y)};
    };
    const auto alone = [](const std::string& step, double value) -> std::vector<std::string> {
        return {step, fmt::format("{:.4f}", value), ""};
    };
    return {row("D", d),
            row("N", n),
            alone("c = −D·N", c),
            row("R = D + 2cN", d + 2 * c * n),
            row("D + cN", along),
            row("A = (D + cN) / 1.5", a),
            alone("A·A", dot(a, a)),
            alone("√(1 − A·A)", std::sqrt(1 - dot(a, a))),
            row("T = A − √(1 − A·A) N", *refracted_direction(d, n, 1, 1.5))};
}

std::vector<std::string> endings_header() { return {"branches that end", "depth 5", "depth 10", "depth 10, τ = 0.01"}; }

Rows endings_rows(const Scene& scene, int threads) {
    std::vector<Endings> found;
    for (const WhittedOptions& options :
         {WhittedOptions{.depth = 5}, WhittedOptions{.depth = 10}, WhittedOptions{.depth = 10, .threshold = 0.01}})
        found.push_back(endings(scene, options, threads));
    Rows rows;
    const auto add_row = [&](const std::string& what, const auto& words) {
        rows.push_back({what});
        for (const Endings& one : found) rows.back().push_back(words(one));
    };
    for (const auto& [what, ending] :
         {std::pair{"at a diffuse surface", Ending::diffuse}, std::pair{"where nothing is hit", Ending::missed},
          std::pair{"by total internal reflection", Ending::total_internal_reflection},
          std::pair{"cut by the depth", Ending::depth}, std::pair{"cut by the throughput", Ending::threshold}})
        add_row(what, [&, ending = ending](const Endings& one) { return share(one, ending); });
    add_row("rays a pixel", [](const Endings& one) { return fmt::format("{:.2f}", one.rays_a_pixel); });
    return rows;
}

Rows hall_of_mirrors_rows() {
    Rows rows;
    for (const int depth : {1, 2, 3, 5, 10, 20, 40})
        rows.push_back({std::to_string(depth), brightness(0.5, depth), brightness(0.9, depth)});
    rows.push_back({"truth", fmt::format("{:.6f}", hall_of_mirrors_truth(0.5)),
                    fmt::format("{:.6f}", hall_of_mirrors_truth(0.9))});
    return rows;
}

}  // namespace raylab::recursion
