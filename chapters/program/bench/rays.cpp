#include "rays.h"

#include "meshes.h"
#include "peer.h"

#include "raylab/base/error.h"
#include "raylab/base/tiles.h"
#include "raylab/geometry/box.h"
#include "raylab/sampling/sequence.h"
#include "raylab/scene/camera.h"

#include <algorithm>
#include <map>

namespace raylab::bench {

namespace {

constexpr double above_the_surface = 1e-4;  // of the mesh's diagonal: beyond any rounding of the start
constexpr std::uint64_t seed = 1;

/// Where a camera's rays arrived.
struct Arrival {
    Vec3d position, normal;  // the unit normal on the camera's side
};

/// The mesh's surroundings, and its exact answers.
class Stage {
public:
    Stage(const Scene& scene, int size)
        : mesh_(mesh_of(scene)),
          box_(*bounds(scene.objects.at(0).shape)),
          size_(size),
          count_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)),
          exact_(make_accelerator("aabb_tree", scene)),
          list_(make_accelerator("list", scene)) {}

    std::vector<Ray> primary() const;
    std::vector<Ray> bounce() const;
    std::vector<Ray> shadow() const;
    std::vector<Ray> segments() const;
    std::vector<std::int32_t> nearest(const std::vector<Ray>& rays) const;

private:
    void check_by_list(const std::vector<Ray>& rays, const std::vector<std::int32_t>& triangles) const;
    double diagonal() const { return glm::length(convert<double>(box_.max) - convert<double>(box_.min)); }
    Vec3d start(const Arrival& arrival) const {
        return arrival.position + above_the_surface * diagonal() * arrival.normal;
    }
    const std::vector<Arrival>& arrivals() const;  // never empty
    template <class Make>
    std::vector<Ray> from_arrivals(const Make& make) const;

    const Mesh& mesh_;
    Box box_;
    int size_;
    std::size_t count_;
    std::unique_ptr<Accelerator> exact_, list_;
    mutable std::vector<Arrival> arrivals_;
};

std::vector<Ray> Stage::primary() const {
    const Vec3d view = glm::normalize(Vec3d{0.5, 0.35, 1});
    const auto frame =
        camera_frame({.position = box_.center() + diagonal() * view, .target = box_.center()}, {size_, size_});
    std::vector<Ray> rays;
    for (int y = 0; y < size_; ++y)
        for (int x = 0; x < size_; ++x) rays.push_back(eye_ray(frame, x + 0.5, y + 0.5));
    return rays;
}

const std::vector<Arrival>& Stage::arrivals() const {
    if (!arrivals_.empty()) return arrivals_;
    Traversal traversal;
    for (const Ray& ray : primary()) {
        const auto hit = exact_->closest(ray, traversal);
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
std::vector<Ray> Stage::from_arrivals(const Make& make) const {
    const auto& from = arrivals();
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count_; ++i) rays.push_back(make(from[i * from.size() / count_], i));
    return rays;
}

std::vector<Ray> Stage::bounce() const {
    return from_arrivals([&](const Arrival& arrival, std::size_t i) -> Ray {
        RandomSequence random(seed, i);
        // A unit normal and a point of the unit sphere: their sum is distributed by the cosine.
        const Vec3d direction = glm::normalize(arrival.normal + random.unit_vector());
        return {convert<float>(start(arrival)), convert<float>(direction)};
    });
}

std::vector<Ray> Stage::shadow() const {
    const Vec3d light = box_.center() + diagonal() * Vec3d{-0.8, 1.2, 0.6};
    return from_arrivals([&](const Arrival& arrival, std::size_t) -> Ray {
        return {convert<float>(start(arrival)), convert<float>(light - start(arrival)), {0, 1}};
    });
}

std::vector<Ray> Stage::segments() const {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count_; ++i) {
        RandomSequence random(seed + 1, i);
        const auto point = [&]() -> Vec3f {
            const double x = random.between(box_.min.x, box_.max.x), y = random.between(box_.min.y, box_.max.y);
            return convert<float>(Vec3d{x, y, random.between(box_.min.z, box_.max.z)});
        };
        const Vec3f from = point(), to = point();
        rays.push_back({from, to - from, {0, 1}});
    }
    return rays;
}

std::vector<std::int32_t> Stage::nearest(const std::vector<Ray>& rays) const {
    std::vector<std::int32_t> triangles(rays.size(), none);
    for_each_piece(rays.size(), 4096, 0, [&](std::size_t begin, std::size_t end) {
        Traversal traversal;
        for (std::size_t i = begin; i < end; ++i)
            if (const auto hit = exact_->closest(rays[i], traversal))
                triangles[i] = static_cast<std::int32_t>(hit->primitive.part);
    });
    check_by_list(rays, triangles);
    return triangles;
}

// The tests show that every structure of ours answers as the list does; here it is asked as often as half a second
// allows.
void Stage::check_by_list(const std::vector<Ray>& rays, const std::vector<std::int32_t>& triangles) const {
    constexpr std::size_t affordable_tests = 30'000'000;
    const std::size_t wanted = std::clamp<std::size_t>(affordable_tests / mesh_.faces.size(), 1, rays.size());
    Traversal traversal;
    for (std::size_t k = 0; k < wanted; ++k) {
        const std::size_t i = k * rays.size() / wanted;
        const auto hit = list_->closest(rays[i], traversal);
        if ((hit ? static_cast<std::int32_t>(hit->primitive.part) : none) == triangles[i]) continue;
        throw Error("ray " + std::to_string(i) + ": expected the same answer of list and aabb_tree, found two");
    }
}

struct Kind {
    const char* name;
    RayQuestion question;
    std::vector<Ray> (Stage::*rays)() const;
};

constexpr Kind kinds[] = {
    {"primary", RayQuestion::nearest, &Stage::primary},   {"bounce", RayQuestion::nearest, &Stage::bounce},
    {"segments", RayQuestion::nearest, &Stage::segments}, {"bounce_any", RayQuestion::any, &Stage::bounce},
    {"shadow", RayQuestion::any, &Stage::shadow},         {"segments_any", RayQuestion::any, &Stage::segments}};

const Kind& kind(const std::string& name) {
    const auto found = std::ranges::find(kinds, name, &Kind::name);
    if (found != std::end(kinds)) return *found;
    std::string known;
    for (const Kind& one : kinds) known += (known.empty() ? "" : ", ") + std::string(one.name);
    throw Error("expected a kind of rays (" + known + "), found \"" + name + "\"");
}

}  // namespace

std::vector<std::string> ray_set_names() {
    std::vector<std::string> names;
    for (const Kind& one : kinds) names.push_back(one.name);
    return names;
}

std::vector<RaySet> ray_sets(const Scene& scene, const std::vector<std::string>& names, int size) {
    const Stage stage(scene, size);
    std::vector<std::pair<decltype(Kind::rays), std::shared_ptr<const Rays>>> made;  // two questions share their rays
    std::vector<RaySet> sets;
    for (const std::string& name : names) {
        const Kind& wanted = kind(name);
        auto found = std::ranges::find(made, wanted.rays, [](const auto& one) { return one.first; });
        if (found == made.end()) {
            auto rays = (stage.*wanted.rays)();
            auto nearest = stage.nearest(rays);
            made.emplace_back(wanted.rays, std::make_shared<const Rays>(std::move(rays), std::move(nearest)));
            found = std::prev(made.end());
        }
        sets.push_back({name, wanted.question, found->second});
    }
    return sets;
}

}  // namespace raylab::bench
