#include "raylab/accelerator/primitives.h"
#include "raylab/experiment/structure/structure_difference.h"
#include "raylab/geometry/shape_parts.h"

#include <algorithm>
#include <map>
#include <memory>

// Delta debugging in its simplest form (Zeller and Hildebrandt: Simplifying and Isolating Failure-Inducing Input, IEEE
// TSE 28(2), 2002).

namespace raylab {

namespace {

std::shared_ptr<const Mesh> with_faces(const Mesh& mesh, const std::vector<Primitive>& kept, std::uint32_t object) {
    auto part = std::make_shared<Mesh>();
    const auto copied = [&](std::uint32_t vertex) {
        part->vertices.push_back(mesh.vertices[vertex]);
        return static_cast<std::uint32_t>(part->vertices.size() - 1);
    };
    for (const Primitive& primitive : kept) {
        if (primitive.object != object) continue;
        const Mesh::Face& face = mesh.faces[primitive.part];
        const std::uint32_t a = copied(face.a), b = copied(face.b), c = copied(face.c);
        part->faces.push_back({a, b, c});
    }
    return part;
}

// The case with only these primitives, in ascending order. Rays still leave the primitive that they left, if it is
// among them.
StructureCase with_primitives(const StructureCase& whole, const std::vector<Primitive>& kept) {
    StructureCase part{.scene = whole.scene, .rays = whole.rays};
    part.scene.objects.clear();
    std::map<Primitive, Primitive> renamed;
    for (std::uint32_t number = 0; number < whole.scene.objects.size(); ++number) {
        const auto here = static_cast<std::uint32_t>(part.scene.objects.size());
        std::uint32_t count = 0;
        for (const Primitive& primitive : kept)
            if (primitive.object == number) renamed[primitive] = {here, count++};
        if (count == 0) continue;
        part.scene.objects.push_back(whole.scene.objects[number]);
        if (const Mesh* mesh = as_mesh(whole.scene.objects[number].shape))
            part.scene.objects.back().shape = with_faces(*mesh, kept, number);
    }
    for (Ray& ray : part.rays) {
        const auto found = renamed.find(ray.leaving);
        ray.leaving = found == renamed.end() ? no_primitive : found->second;
    }
    return part;
}

/// Removes as much of `items` as possible while still_fails(rest): halves, quarters, ..., single ones until none can be
/// removed.
template <class Item, class StillFails>
std::vector<Item> fewest(std::vector<Item> items, const StillFails& still_fails) {
    for (std::size_t chunk = std::max<std::size_t>(1, items.size() / 2);;) {
        bool removed = false;
        for (std::size_t begin = 0; begin < items.size();) {
            std::vector<Item> rest(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(begin));
            rest.insert(rest.end(), items.begin() + static_cast<std::ptrdiff_t>(std::min(items.size(), begin + chunk)),
                        items.end());
            if (still_fails(rest)) {
                items = std::move(rest);
                removed = true;
            } else {
                begin += chunk;
            }
        }
        if (chunk == 1 && !removed) return items;
        if (!removed || chunk > items.size()) chunk = std::max<std::size_t>(1, chunk / 2);
    }
}

// Keeps the rays that are needed: mostly only the last one.
void minimise_rays(StructureCase& failing, const CaseJudge& judge) {
    const auto with = [&](const std::vector<Ray>& rays) { return StructureCase{failing.scene, rays}; };
    const std::vector<Ray> last{failing.rays.back()};
    const auto still_fails = [&](const std::vector<Ray>& rays) {
        return !rays.empty() && judge(with(rays)).has_value();
    };
    failing.rays = still_fails(last) ? last : fewest(failing.rays, still_fails);
}

// Removes from the last ray what is not needed: the primitive it leaves, the end of its range.
void simplify_last_ray(StructureCase& failing, const CaseJudge& judge) {
    const auto attempt = [&](auto change) {
        StructureCase simpler = failing;
        change(simpler.rays.back());
        if (judge(simpler)) failing = std::move(simpler);
    };
    attempt([](Ray& ray) { ray.leaving = no_primitive; });
    attempt([](Ray& ray) { ray.range.min = 0; });
    attempt([](Ray& ray) { ray.range.max = Ray{}.range.max; });
}

}  // namespace

StructureCase minimised(StructureCase failing, const CaseJudge& judge) {
    minimise_rays(failing, judge);
    const auto kept = fewest(primitives_of(failing.scene), [&](const std::vector<Primitive>& some) {
        return judge(with_primitives(failing, some)).has_value();
    });
    StructureCase smallest = with_primitives(failing, kept);
    minimise_rays(smallest, judge);
    simplify_last_ray(smallest, judge);
    return smallest;
}

}  // namespace raylab
