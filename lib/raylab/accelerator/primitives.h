#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/geometry/hull.h"
#include "raylab/geometry/nearest.h"
#include "raylab/geometry/prepared_flat.h"
#include "raylab/geometry/reaches_box.h"
#include "raylab/scene/scene.h"

#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace raylab {

/// The primitives of a scene, meshes taken apart into triangles: what every accelerator holds, in the order that suits
/// it, and tests. Triangles and spheres at rest where they were made lie here themselves, and flat shapes prepared: they
/// are most of what is tested.
class Primitives {
public:
    explicit Primitives(const Scene& scene);  // in scene order
    Primitives(const Scene& scene, std::span<const Primitive> some);
    Primitives(const Primitives& all, std::span<const std::uint32_t> order);

    std::size_t size() const { return items_.size(); }
    std::optional<Box> bounds(std::size_t i) const;  // absent: unbounded
    Hull hull(std::size_t i) const;                  // empty: unbounded
    Target target(std::size_t i) const { return target(items_[i].primitive); }
    Primitive primitive(std::size_t i) const { return items_[i].primitive; }
    std::optional<Triangle> triangle(std::size_t i) const;  // absent: something else, or not at rest where it was made
    std::size_t bytes() const;

    /// Where each stands in scene order: what an Outline has.
    std::vector<std::uint32_t> places() const;

    /// Whether primitive i may reach into a box, grown as `raylab::reaches` wants it: asked where its bounds do.
    bool reaches(std::size_t i, const BoxOfDoubles& box) const;

    /// Offers the hit of primitive i, if there is one, to `nearest`.
    void test(std::size_t i, const Ray& ray, Nearest& nearest, Traversal& traversal) const {
        const auto found = meet(i, ray, traversal);
        if (found) offer(i, *found, nearest, traversal);
    }

    /// Whether the ray hits primitive i.
    bool hits(std::size_t i, const Ray& ray, Traversal& traversal) const { return meet(i, ray, traversal).has_value(); }

private:
    using Flat = std::uint32_t;  // index into flats_
    struct Elsewhere {};         // the scene's object has the shape
    struct Item {
        std::variant<Triangle, Sphere, Flat, Elsewhere> shape;
        Primitive primitive;
        Sides sides;
        enum class Surface : std::uint8_t { flat, curved } surface;
    };

    Item item(const Object& object, Primitive primitive);
    Flat kept(const PreparedFlat& flat);  // in flats_
    Target target(Primitive primitive) const;
    std::optional<Candidate> meet(std::size_t i, const Ray& ray, Traversal& traversal) const;
    std::optional<Candidate> intersection(const Item& item, const Ray& ray, Decisions& decisions) const;
    void offer(std::size_t i, const Candidate& found, Nearest& nearest, Traversal& traversal) const;

    const Scene* scene_;
    std::vector<Item> items_;
    std::vector<PreparedFlat> flats_;
};

}  // namespace raylab
