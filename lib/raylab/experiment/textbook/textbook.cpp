#include "raylab/experiment/textbook/textbook.h"

#include "raylab/experiment/textbook/textbook_surface.h"
#include "raylab/geometry/largest_coordinate.h"
#include "raylab/scene/background.h"
#include "raylab/scene/mean_of_channels.h"
#include "raylab/scene/pigment.h"
#include "raylab/tracer/in_shadow.h"
#include "raylab/tracer/local_color.h"
#include "raylab/tracer/phong_specular.h"
#include "raylab/tracer/refracted_direction.h"
#include "raylab/tracer/shading/illumination.h"
#include "raylab/tracer/traced_color.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raylab {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A traced_color that counts its depth wrongly may not end by itself: rays nested so much deeper bring black.
constexpr int too_deep = 3;
constexpr std::size_t max_branches = 8;  // of one level; a right one has two

// A ray starts beside its surface by this share of the largest coordinate, as in in_shadow().
constexpr double share_of_size = 0x1p-33;

Vec3d beside(const Vec3d& point, const Vec3d& normal, const Vec3d& direction) {
    const double size = std::max(largest_coordinate(point), 1.0);
    return point + normal * (dot(normal, direction) < 0 ? -size : size) * share_of_size;
}

bool is_number(const Vec3d& v) { return !std::isnan(v.x + v.y + v.z); }

RayOf<double> endless(const Vec3d& origin, const Vec3d& direction) { return {origin, direction, {0, infinity}}; }

Ray as_floats(const RayOf<double>& ray) {
    return {.origin = convert<float>(ray.origin), .direction = convert<float>(ray.direction)};
}

// One ray that traced_color asked for, and its share of the level's colour.
struct Branch {
    Vec3d direction;
    int depth;
    double share = 0;
};

class Textbook {
public:
    Textbook(const Scene& scene, int limit) : scene_(scene), limit_(limit) {}

    RayTree tree(const RayOf<double>& eye_ray) {
        tree_.pixel = color({.kind = RayKind::eye, .ray = as_floats(eye_ray)}, eye_ray);
        return std::move(tree_);
    }

private:
    Color color(const RayNode& cast, const RayOf<double>& ray) {
        const std::size_t node = tree_.nodes.size();
        tree_.nodes.push_back(cast);
        const auto hit_found = textbook_surface(scene_, ray);
        TracedLevel level{.depth = cast.depth,
                          .limit = limit_,
                          .nearest = {},
                          .background = background_color(scene_.background, cast.ray.direction),
                          .trace = {}};
        if (hit_found)
            level.nearest = surface(*hit_found, ray.direction, node);
        else
            tree_.nodes[node].ended = Ending::missed;
        const auto branches = asked(level, node);
        std::size_t call = 0;
        ++nesting_;
        level.trace = [&](const Vec3d&, int) {
            const std::size_t i = call++;
            return i < branches.size() ? follow(branches[i], node, level, *hit_found) : Color{0, 0, 0};
        };
        const Color sum = traced_color(level);
        --nesting_;
        if (hit_found) cut(node, level, branches);
        return sum;
    }

    // Finds which rays a level asks for and what it makes of them: it is asked once with rays that bring black, which
    // leaves its own colour, then with each in turn bringing white.
    std::vector<Branch> asked(TracedLevel level, std::size_t node) {
        std::vector<Branch> branches;
        level.trace = [&](const Vec3d& direction, int depth) {
            if (branches.size() < max_branches) branches.push_back({direction, depth});
            return Color{0, 0, 0};
        };
        const Color own = traced_color(level);
        for (std::size_t white = 0; white < branches.size(); ++white) {
            std::size_t call = 0;
            level.trace = [&](const Vec3d&, int) { return call++ == white ? Color{1, 1, 1} : Color{0, 0, 0}; };
            const Color more = traced_color(level) - own;
            branches[white].share = mean_of_channels(more);
        }
        RayNode& n = tree_.nodes[node];
        n.local = own;
        n.contribution = n.throughput * own;
        return branches;
    }

    Color follow(const Branch& branch, std::size_t parent, const TracedLevel& level, const TextbookSurface& from) {
        if (nesting_ > limit_ + too_deep) return {0, 0, 0};
        const bool transmitted = is_transmitted(branch.direction, *level.nearest, parent);
        const auto ray = endless(beside(from.position, from.normal, branch.direction), branch.direction);
        return color({.kind = transmitted ? RayKind::transmitted : RayKind::reflected,
                      .parent = parent,
                      .depth = branch.depth,
                      .throughput = tree_.nodes[parent].throughput * branch.share,
                      .ray = as_floats(ray)},
                     ray);
    }

    // The nearer one of the two that the surface has. Of a direction that is no number, which a student's function may
    // give, no comparison tells: it is the refracted one if that is none, either, or if the mirrored one was followed.
    bool is_transmitted(const Vec3d& direction, const TracedSurface& surface, std::size_t parent) const {
        if (!surface.refracted) return false;
        if (!is_number(*surface.refracted)) return !is_number(direction);
        if (is_number(direction))
            return glm::length(direction - *surface.refracted) < glm::length(direction - surface.mirrored);
        return std::ranges::any_of(tree_.nodes, [parent](const RayNode& node) {
            return node.parent == parent && node.kind == RayKind::reflected;
        });
    }

    // Branches that the surface has and the level did not ask for, as it should where they would be too deep.
    void cut(std::size_t node, const TracedLevel& level, const std::vector<Branch>& branches) {
        const auto& [local, kr, kt, mirrored, refracted] = *level.nearest;
        const double throughput = tree_.nodes[node].throughput;
        const int depth = level.depth + 1;
        if (level.depth >= limit_ && branches.empty()) {
            if (const double share = refracted ? kr : kr + kt; share > 0)
                add_cut(RayKind::reflected, Ending::depth, node, depth, throughput * share);
            if (refracted && kt > 0) add_cut(RayKind::transmitted, Ending::depth, node, depth, throughput * kt);
        }
        if (!refracted && kt > 0) add_cut(RayKind::transmitted, Ending::total_internal_reflection, node, depth, 0);
    }

    void add_cut(RayKind kind, Ending ended, std::size_t parent, int depth, double throughput) {
        tree_.nodes.push_back(
            {.kind = kind, .ended = ended, .parent = parent, .depth = depth, .throughput = throughput});
    }

    // The parts of a level where a surface is hit.
    TracedSurface surface(const TextbookSurface& hit_found, const Vec3d& direction, std::size_t node) {
        const Object& object = *hit_found.object;
        const Material& material = scene_.materials[hit_found.outside ? object.front : object.back];
        RayNode& n = tree_.nodes[node];
        n.object = object.path;
        n.t = hit_found.t;
        n.point = hit_found.position;
        n.normal = hit_found.outside ? hit_found.normal : -hit_found.normal;
        n.ended = material.kr == 0 && material.kt == 0 ? Ending::diffuse : Ending::branched;
        const Vec3d unit = glm::normalize(direction);
        TracedSurface result{.local = local(hit_found, material, -unit, node),
                             .kr = material.kr,
                             .kt = material.kt,
                             .mirrored = unit - 2 * dot(unit, hit_found.normal) * hit_found.normal,
                             .refracted = {}};
        const double ior = scene_.materials[object.front].ior;
        if (material.kt > 0)
            result.refracted =
                refracted_direction(unit, hit_found.normal, hit_found.outside ? 1 : ior, hit_found.outside ? ior : 1);
        return result;
    }

    // I_local: what the point has without lights, and what comes from those that are seen.
    Color local(const TextbookSurface& hit_found, const Material& material, const Vec3d& to_viewer, std::size_t node) {
        LocalSurface surface{.normal = hit_found.normal,
                             .to_viewer = to_viewer,
                             .unlit = {0, 0, 0},
                             .diffuse = color_at(material.diffuse, hit_found.position, hit_found.normal),
                             .specular = material.specular,
                             .shininess = material.shininess};
        const FirstHit first_hit = [&](const Vec3d& origin, const Vec3d& direction) -> std::optional<double> {
            const auto obstacle =
                textbook_surface(scene_, {origin, direction, {std::numeric_limits<double>::min(), infinity}});
            return obstacle ? std::optional(obstacle->t) : std::nullopt;
        };
        std::vector<IncidentLight> seen;
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
            const auto light = illumination(steady(scene_.lights[i]), hit_found.position);
            if (!light) continue;
            const IncidentLight asked{light->distance * light->to_light, light->color, scene_.lights[i].attenuation};
            const bool dark =
                in_shadow(hit_found.position, hit_found.normal, hit_found.position + asked.way, first_hit);
            const Color brought = dark ? Color{0, 0, 0} : local_color(surface, std::span(&asked, 1));
            add_shadow_ray(node, i, endless(hit_found.position, light->to_light),
                           dark ? Ending::blocked : Ending::reached, brought);
            if (!dark) seen.push_back(asked);
        }
        surface.unlit = material.emission + material.ambient * scene_.background.ambient;
        return local_color(surface, seen);
    }

    // The light without its attenuation, which local_color() sees to.
    static Light steady(Light light) {
        light.attenuation = {1, 0, 0};
        return light;
    }

    void add_shadow_ray(std::size_t parent, std::size_t light, const RayOf<double>& ray, Ending ended,
                        const Color& brought) {
        const auto [depth, throughput] = std::pair(tree_.nodes[parent].depth + 1, tree_.nodes[parent].throughput);
        tree_.nodes.push_back({.kind = RayKind::shadow,
                               .ended = ended,
                               .parent = parent,
                               .light = light,
                               .depth = depth,
                               .throughput = throughput,
                               .ray = as_floats(ray),
                               .local = brought,
                               .contribution = throughput * brought});
    }

    const Scene& scene_;
    const int limit_;
    int nesting_ = 0;
    RayTree tree_;
};

}  // namespace

RayTree textbook_tree(const Scene& scene, const RayOf<double>& eye_ray, int limit) {
    return Textbook(scene, limit).tree(eye_ray);
}

}  // namespace raylab
