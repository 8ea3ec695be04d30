#include "raylab/radiosity/visibility.h"

#include "raylab/geometry/local_frame.h"
#include "raylab/radiosity/mesh/convex_room.h"
#include "raylab/sampling/even_point.h"
#include "raylab/sampling/mapping/cosine_direction.h"
#include "raylab/sampling/random.h"
#include "raylab/scene/background.h"
#include "raylab/tracer/shading/ray_start.h"

#include <algorithm>
#include <array>
#include <limits>

namespace raylab {

namespace {

// Short of the other point by as much as rounding may move it: a ray that ended on that point's own polygon would be
// decided by exact numbers each time, and ten times slower.
const float ray_end = cast<float>(length_of_shadow_ray(1));

Scene seen_from_both_sides(Scene scene) {
    for (Object& object : scene.objects) object.sides = Sides::both;
    return scene;
}

}  // namespace

PatchVisibility::PatchVisibility(const PatchMesh& mesh)
    : mesh_(mesh),
      occluders_(seen_from_both_sides(mesh.model.scene)),
      accelerator_(make_accelerator("auto", occluders_)),
      nothing_hides_(is_convex_room(mesh.model.facets)) {}

// The ray first asks for any hit, which is cheap. Only where there is one it asks for the nearest: that may be one of
// the two patches' own polygons, whose points are rounded.
bool PatchVisibility::is_open(const Ray& ray, std::uint32_t from, const std::uint32_t* to, Traversal& traversal) const {
    if (!accelerator_->occluded(ray, traversal)) return true;
    const auto hit = accelerator_->closest(ray, traversal);
    if (!hit) return true;
    const std::uint32_t found = hit->primitive.object;
    return (to && found == mesh_.occluder(mesh_.patches[*to])) || found == mesh_.occluder(mesh_.patches[from]);
}

bool PatchVisibility::sees(std::uint32_t from, const Vec3d& start, std::uint32_t to, const Vec3d& end,
                           Traversal& traversal) const {
    const Vec3f origin = convert<float>(start);
    const Vec3f direction = convert<float>(end - convert<double>(origin));
    const Primitive leaving{mesh_.occluder(mesh_.patches[from]), 0};
    return is_open({origin, direction, {0, ray_end}, leaving}, from, &to, traversal);
}

bool PatchVisibility::sees_point(std::uint32_t from, const Vec3d& start, const Vec3d& end, Traversal& traversal) const {
    const Vec3f origin = convert<float>(start);
    const Vec3f direction = convert<float>(end - convert<double>(origin));
    const Primitive leaving{mesh_.occluder(mesh_.patches[from]), 0};
    return is_open({origin, direction, {0, ray_end}, leaving}, from, nullptr, traversal);
}

bool PatchVisibility::sees_direction(std::uint32_t from, const Vec3d& start, const Vec3d& direction,
                                     Traversal& traversal) const {
    const Primitive leaving{mesh_.occluder(mesh_.patches[from]), 0};
    return is_open(
        {convert<float>(start), convert<float>(direction), {0, std::numeric_limits<float>::infinity()}, leaving}, from,
        nullptr, traversal);
}

PatchVisibility::OpenShare PatchVisibility::share(std::uint32_t a, std::uint32_t b, int rays,
                                                  Traversal& traversal) const {
    return share(Part{a, mesh_.patches[a]}, Part{b, mesh_.patches[b]}, rays, shifts_of_pair(a, b), traversal);
}

PatchVisibility::OpenShare PatchVisibility::share(const Part& a, const Part& b, int rays,
                                                  const std::array<double, 4>& shifts, Traversal& traversal) const {
    if (rays == 0) return {1, 0};
    // Where patches touch, the weight has no bound: distances below a hundredth of the smaller patch count as that.
    const double nearest = 1e-4 * std::min(a.patch.area, b.patch.area);
    double open = 0, all = 0, squares = 0;
    int cast = 0;
    for (int i = 0, most = 4 * rays; i < most && cast < rays; ++i) {
        const auto [u, v, s, t] = even_point<4>(i + 1, shifts);
        const Vec3d from = point_of(a.patch, u, v), to = point_of(b.patch, s, t), way = to - from;
        const double cosines = dot(a.patch.normal, way) * -dot(b.patch.normal, way), apart = dot(way, way) + nearest;
        if (!(dot(a.patch.normal, way) > 0 && cosines > 0)) continue;
        ++cast;
        const double weight = cosines / (apart * apart);
        all += weight;
        squares += weight * weight;
        if (sees(a.of, from, b.of, to, traversal)) open += weight;
    }
    return all > 0 ? OpenShare{open / all, all * all / squares} : OpenShare{0, 1};
}

template <class PointAt>
PatchVisibility::Surroundings PatchVisibility::seen_around(std::uint32_t of, const Vec3d& normal, int rays,
                                                           const PointAt& point_at, Traversal& traversal) const {
    const Primitive leaving{mesh_.occluder(mesh_.patches[of]), 0};
    const LocalFrame frame = frame_around(normal);
    int open = 0, outside = 0;
    Vec3d background{0, 0, 0};
    for (int i = 0; i < rays; ++i) {
        const auto [u, v, s, t] = even_point<4>(i + 1, {0.5, 0.5, 0.5, 0.5});
        const Vec3d direction = frame.to_world(cosine_direction(s, t).direction);
        const Ray ray{convert<float>(point_at(u, v)),
                      convert<float>(direction),
                      {0, std::numeric_limits<float>::infinity()},
                      leaving};
        const auto hit = accelerator_->closest(ray, traversal);
        if (!hit) {
            background += background_color(mesh_.model.scene.background, ray.direction);
            ++outside;
        } else if (mesh_.has_patches(hit->primitive.object, mesh_.side_towards(hit->primitive.object, -direction))) {
            ++open;
        }
    }
    return {static_cast<double>(open + outside) / rays, outside > 0 ? background / (1.0 * outside) : background};
}

PatchVisibility::Surroundings PatchVisibility::surroundings(const Part& part, int rays, Traversal& traversal) const {
    return seen_around(
        part.of, part.patch.normal, rays, [&](double u, double v) { return point_of(part.patch, u, v); }, traversal);
}

PatchVisibility::Surroundings PatchVisibility::surroundings(std::uint32_t of, const Vec3d& point, int rays,
                                                            Traversal& traversal) const {
    return seen_around(
        of, mesh_.patches[of].normal, rays, [&](double, double) { return point; }, traversal);
}

std::array<double, 4> shifts_of_pair(std::uint64_t a, std::uint64_t b) {
    const auto random = [&](std::uint64_t dimension) {
        return random_number({.seed = 1, .pixel = a, .sample = b, .dimension = dimension});
    };
    return {random(0), random(1), random(2), random(3)};
}

Vec3d point_of(const Patch& patch, double u, double v) {
    const auto& c = patch.corners;
    if (patch.corner_count == 4) return glm::mix(glm::mix(c[0], c[1], u), glm::mix(c[3], c[2], u), v);
    if (u + v > 1) {  // the other half of the parallelogram, turned over
        u = 1 - u;
        v = 1 - v;
    }
    return c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]);
}

}  // namespace raylab
