#pragma once

#include "raylab/geometry/ray.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace raylab {

struct Scene;

/// What belongs to the caller while rays cross the seam, one per thread: counts (and, later, mailboxes and a shadow
/// cache). Structures stay const.
struct Traversal {
    std::uint64_t primitive_tests = 0;
    std::uint64_t box_tests = 0;
    std::uint64_t exact_decisions = 0;  // how often the filter left a decision to exact arithmetic

    void add(const Traversal& other) {
        primitive_tests += other.primitive_tests;
        box_tests += other.box_tests;
        exact_decisions += other.exact_decisions;
    }
};

/// The seam: every structure answers the same question, so all give the same answer: the same primitive and the same
/// bits of t, for every ray. Among hits at equal t the lowest primitive wins.
class Accelerator {
public:
    virtual ~Accelerator() = default;
    virtual std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const = 0;  // nearest hit inside ray.range
    virtual bool occluded(const Ray& ray, Traversal& traversal) const = 0;               // any hit inside ray.range
    virtual std::size_t bytes() const = 0;  // allocated beyond the scene's own arrays
};

/// By name, as `--accelerator` has it: "list", "boxed_list", "aabb_tree", "auto". Error names the known ones. The scene must outlive
/// the structure.
std::unique_ptr<Accelerator> make_accelerator(const std::string& name, const Scene& scene);

}  // namespace raylab
