#include "ray_maker.h"

#include "meshes.h"

#include "raylab/base/error.h"
#include "raylab/sampling/sequence.h"
#include "raylab/scene/camera.h"

namespace raylab::bench {

namespace {

constexpr double above_the_surface = 1e-4;  // of the mesh's diagonal; larger than any rounding error of the start
constexpr std::uint64_t seed = 1;

Vec3f point_in(const Box& box, RandomSequence& random) {
    const double x = random.between(box.min.x, box.max.x), y = random.between(box.min.y, box.max.y);
    return convert<float>(Vec3d{x, y, random.between(box.min.z, box.max.z)});
}

}  // namespace

RayMaker::RayMaker(const Scene& scene, const Accelerator& exact, int size)
    : scene_(scene),
      mesh_(mesh_of(scene)),
      exact_(exact),
      box_(*bounds(scene.objects.at(0).shape)),
      size_(size),
      count_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}

Vec3d RayMaker::start(const Arrival& arrival) const {
    return arrival.position + above_the_surface * diagonal() * arrival.normal;
}

std::vector<Ray> RayMaker::primary() const {
    const auto frame = camera_frame(scene_.camera, {size_, size_});
    std::vector<Ray> rays;
    for (int y = 0; y < size_; ++y)
        for (int x = 0; x < size_; ++x) rays.push_back(eye_ray(frame, x + 0.5, y + 0.5));
    return rays;
}

const std::vector<Arrival>& RayMaker::arrivals() const {
    if (!arrivals_.empty()) return arrivals_;
    Traversal traversal;
    for (const Ray& ray : primary()) {
        const auto hit = exact_.closest(ray, traversal);
        if (!hit) continue;
        const auto [a, b, c] = in<double>(mesh_.triangle(hit->primitive.part));
        const auto direction = convert<double>(ray.direction);
        const Vec3d normal = glm::normalize(cross(b - a, c - a));
        arrivals_.push_back(
            {convert<double>(ray.origin) + hit->t * direction, dot(normal, direction) < 0 ? normal : -normal});
    }
    if (arrivals_.empty()) throw Error("expected a mesh that the camera sees, found that all its rays miss");
    return arrivals_;
}

template <class Make>
std::vector<Ray> RayMaker::from_arrivals(const Make& make) const {
    const auto& from = arrivals();
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count_; ++i) rays.push_back(make(from[i * from.size() / count_], i));
    return rays;
}

std::vector<Ray> RayMaker::bounce() const {
    return from_arrivals([&](const Arrival& arrival, std::size_t i) -> Ray {
        RandomSequence random(seed, i);
        // The sum of a unit normal and a point of the unit sphere is distributed with the cosine.
        const Vec3d direction = glm::normalize(arrival.normal + random.unit_vector());
        return {convert<float>(start(arrival)), convert<float>(direction)};
    });
}

std::vector<Ray> RayMaker::shadow() const {
    const Vec3d light = std::get<PointLight>(scene_.lights.at(0).kind).position;
    return from_arrivals([&](const Arrival& arrival, std::size_t) -> Ray {
        return {convert<float>(start(arrival)), convert<float>(light - start(arrival)), {0, 1}};
    });
}

std::vector<Ray> RayMaker::segments() const {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count_; ++i) {
        RandomSequence random(seed + 1, i);
        const Vec3f from = point_in(box_, random), to = point_in(box_, random);
        rays.push_back({from, to - from, {0, 1}});
    }
    return rays;
}

std::vector<Ray> RayMaker::aimed() const {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count_; ++i) {
        RandomSequence random(seed + 2, i);
        const auto [a, b, c] = mesh_.triangle(random_bits({.seed = seed, .pixel = i}) % mesh_.faces.size());
        const Vec3f from = point_in(box_, random), to = i % 2 == 0 ? a : 0.5f * (a + b);
        rays.push_back({from, to - from});
    }
    return rays;
}

}  // namespace raylab::bench
