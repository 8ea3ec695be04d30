#include "raylab/experiment/structure/structure_workload.h"

#include "raylab/geometry/shape_parts.h"
#include "raylab/sampling/sequence.h"
#include "raylab/scene/camera.h"
#include "raylab/scene/scene_bounds.h"
#include "raylab/tracer/shading/ray_start.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace raylab {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The box about all bounded objects; some box where there are none.
Box bounds_of(const Scene& scene) {
    const Box box = scene_bounds(scene);
    return box.is_empty() ? Box{Vec3f(-1), Vec3f(1)} : box;
}

Vec3d half_diagonal(const Box& box) { return (convert<double>(box.max) - convert<double>(box.min)) * 0.5; }

/// The point where a camera ray hit a surface.
struct Arrival {
    Ray ray;
    double t;
    SurfacePoint surface;
    Vec3d normal;  // on the side from which the ray came
};

/// Random points that the camera sees, in the order of the picture, each for as many rays as are wanted.
class Arrivals {
public:
    Arrivals(const Scene& scene, std::size_t wanted)
        : scene_(scene),
          accelerator_(make_accelerator("auto", scene)),
          side_(std::max(1, static_cast<int>(std::sqrt(static_cast<double>(wanted))))),
          frame_(camera_frame(scene.camera, {side_, side_}, scene.source)) {}

    /// Calls add(arrival, random) until it has returned true that many times; it gives up where the camera hits almost
    /// nothing.
    template <class Add>
    void collect(std::size_t wanted, std::uint64_t seed, const Add& add) const {
        std::size_t added = 0;
        for (std::uint64_t pass = 0; pass < 40 && added < wanted; ++pass)
            for (int pixel = 0; pixel < side_ * side_ && added < wanted; ++pixel) {
                RandomSequence random(seed, static_cast<std::uint64_t>(pixel), pass);
                const double x = pixel % side_ + random.next(), y = pixel / side_ + random.next();
                if (const auto arrival = at(x, y); arrival && add(*arrival, random)) ++added;
            }
    }

private:
    std::optional<Arrival> at(double x, double y) const {
        Traversal traversal;
        const Ray ray = eye_ray(frame_, x, y);
        const auto hit = accelerator_->closest(ray, traversal);
        if (!hit) return std::nullopt;
        const SurfacePoint surface = surface_point(scene_, ray, *hit);
        return Arrival{ray, hit->t, surface, facing(surface.normal, convert<double>(ray.direction))};
    }

    const Scene& scene_;
    std::unique_ptr<Accelerator> accelerator_;
    int side_;
    CameraFrame frame_;
};

}  // namespace

void look_at_all(Scene& scene) {
    const Box box = bounds_of(scene);
    const double reach = std::max(glm::length(half_diagonal(box)), 1e-30);
    const Vec3d center = box.center();
    // Seen from this position, the sphere about the box just fits into the picture.
    scene.camera = {.position = center + glm::normalize(Vec3d{0.5, 0.6, 1}) * (2.8 * reach),
                    .target = center,
                    .projection = Perspective{40}};
    scene.lights = {{.kind = PointLight{center + Vec3d{-1.5, 2.5, 2} * reach}}};
    scene.image = {400, 400};
    if (scene.materials.empty()) scene.materials = {{}};
}

Scene mesh_scene(std::shared_ptr<const Mesh> mesh, const std::string& name) {
    Scene scene;
    scene.source = name;
    scene.objects.push_back({.shape = std::move(mesh)});
    look_at_all(scene);
    return scene;
}

StructureWorkload camera_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays) {
    StructureWorkload result{name + ": camera", "neighbours go almost the same way", scene};
    const int side = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(rays))));
    const CameraFrame frame = camera_frame(scene->camera, {side, side}, scene->source);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) result.rays.push_back(eye_ray(frame, x + 0.5, y + 0.5));
    return result;
}

StructureWorkload bounce_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                              std::uint64_t seed) {
    StructureWorkload result{name + ": bounces", "from surfaces into random directions", scene};
    Arrivals(*scene, rays).collect(rays, seed, [&](const Arrival& from, RandomSequence& random) {
        const Vec3d way = from.normal + random.unit_vector();  // distributed with the cosine to the normal
        if (!(dot(way, from.normal) > 1e-3)) return false;
        result.rays.push_back(ray_from(from.surface, glm::normalize(way), infinity, {}, from.ray, from.t));
        return true;
    });
    return result;
}

StructureWorkload shadow_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                              std::uint64_t seed) {
    StructureWorkload result{name + ": shadow", "from surfaces to a light: is anything in the way?", scene,
                             RayQuestion::any};
    Arrivals(*scene, rays).collect(rays, seed, [&](const Arrival& from, RandomSequence& random) {
        const auto last = static_cast<int>(scene->lights.size()) - 1;
        const auto& light = scene->lights[static_cast<std::size_t>(random.whole(0, last))];
        const auto seen = illumination(light, from.surface.position);
        if (!seen || !(dot(seen->to_light, from.normal) > 1e-3)) return false;
        result.rays.push_back(shadow_ray(from.surface, *seen, {}, from.ray, from.t));
        return true;
    });
    return result;
}

StructureWorkload incoherent_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                                  std::uint64_t seed) {
    StructureWorkload result{name + ": incoherent", "between random points in and about the scene", scene};
    const Box box = bounds_of(*scene);
    for (std::size_t i = 0; i < rays; ++i) {
        RandomSequence random(seed, i);
        const auto point = [&] { return convert<float>(box.center() + 2.0 * half_diagonal(box) * random.in_cube()); };
        const Vec3f from = point(), to = point();
        if (from != to) result.rays.push_back({.origin = from, .direction = to - from, .range = {0, 1}});
    }
    return result;
}

namespace {

// A point on the boundary of an object's box: a vertex of a mesh, or the middle of a face of the box. Absent for a
// plane.
std::optional<Vec3f> extreme_point(const Object& object, RandomSequence& random) {
    if (const Mesh* mesh = as_mesh(object.shape)) {
        const auto& vertices = mesh->vertices;
        if (vertices.empty()) return std::nullopt;
        const auto& vertex = vertices[static_cast<std::size_t>(random.whole(0, static_cast<int>(vertices.size()) - 1))];
        return convert<float>(transform_point(object.placement, convert<double>(vertex)));
    }
    const auto box = bounds(object.shape, object.placement);
    if (!box) return std::nullopt;
    Vec3f point = convert<float>(box->center());
    const int axis = random.whole(0, 2);
    point[axis] = random.next() < 0.5 ? box->min[axis] : box->max[axis];
    return point;
}

}  // namespace

StructureWorkload edge_rays(const std::string& name, const std::shared_ptr<const Scene>& scene, std::size_t rays,
                            std::uint64_t seed) {
    StructureWorkload result{name + ": edges", "at vertices, and along axes in the planes of boxes", scene};
    const Box box = bounds_of(*scene);
    const double reach = glm::length(half_diagonal(box));
    for (std::uint64_t tried = 0; tried < 4 * rays && result.rays.size() < rays && !scene->objects.empty(); ++tried) {
        RandomSequence random(seed, tried);
        const auto number = random.whole(0, static_cast<int>(scene->objects.size()) - 1);
        const auto target = extreme_point(scene->objects[static_cast<std::size_t>(number)], random);
        if (!target) continue;
        Ray ray{.origin = *target, .direction = Vec3f(0)};
        if (random.next() < 0.5) {
            const int axis = random.whole(0, 2);
            ray.direction[axis] = random.next() < 0.5 ? -1.0f : 1.0f;
            ray.origin[axis] -= ray.direction[axis] * cast<float>(3 * reach);
        } else {
            ray.origin = convert<float>(box.center() + random.unit_vector() * (3 * reach));
            ray.direction = *target - ray.origin;
        }
        result.rays.push_back(ray);
    }
    return result;
}

std::vector<StructureWorkload> ray_workloads(const std::string& name, const std::shared_ptr<const Scene>& scene,
                                             std::size_t rays, std::uint64_t seed) {
    return {camera_rays(name, scene, rays), bounce_rays(name, scene, rays, seed),
            shadow_rays(name, scene, rays, seed + 1), incoherent_rays(name, scene, rays, seed + 2)};
}

}  // namespace raylab
