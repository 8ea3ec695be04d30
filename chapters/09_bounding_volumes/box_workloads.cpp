#include "box_tests.h"

#include "raylab/sampling/sequence.h"

namespace raylab::volumes {

namespace {

struct Drawn {
    Ray ray;
    Box box;
};

Box box_at(const Vec3d& center, const Vec3d& half) {
    const Vec3f a = convert<float>(center - half), b = convert<float>(center + half);
    return {glm::min(a, b), glm::max(a, b)};
}

Box any_box(RandomSequence& random, const Vec3d& center) {
    return box_at(center + random.in_cube(),
                  Vec3d{random.between(0.01, 1), random.between(0.01, 1), random.between(0.01, 1)});
}

float one_of(RandomSequence& random, float a, float b) { return random.next() < 0.5 ? a : b; }

Vec3d inside(RandomSequence& random, const Box& box) {
    const auto at = [&](int axis) { return random.between(box.min[axis], box.max[axis]); };
    return {at(0), at(1), at(2)};
}

// The direction has length 1, rounded.
Ray toward(RandomSequence& random, const Vec3d& point, const Vec3d& center, double from) {
    const Vec3f origin = convert<float>(center + random.unit_vector() * from);
    return {origin, convert<float>(glm::normalize(point - convert<double>(origin)))};
}

Drawn at_random(RandomSequence& random) {
    const Box box = any_box(random, {0, 0, 0});
    return {toward(random, random.in_cube() * 2.0, {0, 0, 0}, 6), box};
}

Drawn at_edge(RandomSequence& random) {
    const Box box = any_box(random, {0, 0, 0});
    const int along = random.whole(0, 2);
    Vec3d point = inside(random, box);
    for (int axis = 0; axis < 3; ++axis)
        if (axis != along) point[axis] = one_of(random, box.min[axis], box.max[axis]);
    return {toward(random, point, {0, 0, 0}, 6), box};
}

Drawn at_corner_of(RandomSequence& random, const Vec3d& center) {
    const Box box = any_box(random, center);
    Vec3d point{};
    for (int axis = 0; axis < 3; ++axis) point[axis] = one_of(random, box.min[axis], box.max[axis]);
    return {toward(random, point, center, 6), box};
}

Drawn at_corner(RandomSequence& random) { return at_corner_of(random, {0, 0, 0}); }

Drawn at_far_corner(RandomSequence& random) { return at_corner_of(random, {1e6, -7e5, 4e5}); }

// A ray along an axis from a point in the plane of a face, which gives 0 * infinity. It always hits the box.
Drawn in_plane(RandomSequence& random) {
    const Box box = any_box(random, {0, 0, 0});
    const int along = random.whole(0, 2), across = (along + random.whole(1, 2)) % 3;
    const float forward = random.next() < 0.5 ? 1.0f : -1.0f;
    Ray ray{convert<float>(inside(random, box)), {0, 0, 0}};
    for (int axis = 0; axis < 3; ++axis) ray.direction[axis] = random.next() < 0.5 ? 0.0f : -0.0f;
    ray.direction[along] = forward;
    ray.origin[along] = -5 * forward;
    ray.origin[across] = one_of(random, box.min[across], box.max[across]);
    return {ray, box};
}

// A box without thickness, like a wall's, and a ray in its plane, which hits it or not.
Drawn at_flat_box(RandomSequence& random) {
    Box box = any_box(random, {0, 0, 0});
    const int across = random.whole(0, 2);
    box.max[across] = box.min[across];
    Vec3d point = random.in_cube() * 2.0;
    point[across] = box.min[across];
    Ray ray = toward(random, point, {0, 0, 0}, 6);
    ray.origin[across] = box.min[across];
    ray.direction[across] = random.next() < 0.5 ? 0.0f : -0.0f;
    return {ray, box};
}

BoxWorkload drawn(const std::string& name, const std::string& about, std::size_t queries, std::uint64_t seed,
                  Drawn (*draw)(RandomSequence&)) {
    BoxWorkload workload{name, about, {}, {}};
    for (std::size_t i = 0; i < queries; ++i) {
        RandomSequence random(seed, i);
        const auto [ray, box] = draw(random);
        workload.data.push_back(box);
        workload.queries.push_back({ray, static_cast<std::uint32_t>(i)});
    }
    return workload;
}

}  // namespace

std::vector<BoxWorkload> box_workloads(std::size_t queries, std::uint64_t seed) {
    return {drawn("random", "boxes and rays anywhere", queries, seed, at_random),
            drawn("at edges",
                  "rays that go through an edge, but for the rounding of "
                  "their direction",
                  queries, seed, at_edge),
            drawn("at corners", "... through a corner", queries, seed, at_corner),
            drawn("at corners, far", "... a thousand kilometres from the origin", queries, seed, at_far_corner),
            drawn("in a plane", "rays along an axis, in the plane of a face", queries, seed, in_plane),
            drawn("flat boxes", "boxes without thickness, rays in their plane", queries, seed, at_flat_box)};
}

Truth box_truth(const BoxWorkload& workload, int threads) {
    return ask_oracle(workload.queries.size(), threads, [&](std::size_t i) {
        return oracle::intersect(in<double>(workload.queries[i].ray), workload.data[workload.queries[i].box]);
    });
}

}  // namespace raylab::volumes
