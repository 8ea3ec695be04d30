#pragma once

#include "raylab/accelerator/mailboxes.h"
#include "raylab/accelerator/outline.h"
#include "raylab/geometry/ray.h"
#include "raylab/number/exact_arithmetic.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace raylab {

struct Scene;

/// The primitive that occluded the last shadow ray to a light, by the number the structure gave it. The next shadow ray
/// to this light is tested against it first, because that ray mostly starts nearby and is stopped by the same
/// primitive. (Haines and Greenberg, The Light Buffer, IEEE CG&A 6(9), 1986.)
using Blocker = std::optional<std::uint32_t>;

/// Counts of the work that finding hits took.
struct TestCounts {
    std::uint64_t primitive_tests = 0;
    std::uint64_t box_tests = 0;        // tests of a ray against any bounds: boxes, spheres, oriented boxes
    std::uint64_t steps = 0;            // cells or nodes visited
    std::uint64_t exact_decisions = 0;  // how often the filter left a decision to exact arithmetic

    void add(const TestCounts& other) {
        primitive_tests += other.primitive_tests;
        box_tests += other.box_tests;
        steps += other.steps;
        exact_decisions += other.exact_decisions;
    }
};

/// The mutable state of one thread that queries one structure: counts, and the last blocker of each light. The caller
/// owns it, so that structures stay const.
struct Traversal : TestCounts {
    std::vector<Blocker> blockers = {};  // one for each light; empty while rays have nothing in common
    std::size_t light = 0;               // the light that the next shadow rays go to
    Mailboxes mailboxes = {};            // used by the grid of chapter 10
    [[no_unique_address]] ExactArithmetic arithmetic = {};

    /// Says that the rays from now on are shadow rays to this light.
    void toward(std::size_t number) {
        light = number;
        if (blockers.size() <= light) blockers.resize(light + 1);
    }

    /// Whether the light's last blocker occludes this ray too, as `hits(number)` tells; if it does not, it is
    /// forgotten.
    template <class Hits>
    [[gnu::always_inline]] bool stopped_again(const Hits& hits) {
        if (blockers.empty() || !blockers[light]) return false;
        if (hits(*blockers[light])) return true;
        blockers[light].reset();
        return false;
    }
    void stopped_by(std::size_t number) {
        if (!blockers.empty()) blockers[light] = static_cast<std::uint32_t>(number);
    }
};

/// The interface of all structures. Every structure answers the same question, so all give the same answer: the same
/// primitive and the same bits of t, for every ray. Among hits at equal t the primitive with the lowest number wins. A
/// ray whose direction is zero hits nothing.
class Accelerator {
public:
    virtual ~Accelerator() = default;
    /// The nearest hit inside ray.range.
    virtual std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const = 0;
    /// Whether there is any hit inside ray.range.
    virtual bool occluded(const Ray& ray, Traversal& traversal) const = 0;

    /// The nearest hit of each of several rays, in their order. The answers are those of closest(); a structure may
    /// share work between neighbouring rays.
    virtual std::vector<std::optional<Hit>> closest_of(std::span<const Ray> rays, Traversal& traversal) const {
        std::vector<std::optional<Hit>> hits;
        hits.reserve(rays.size());
        for (const Ray& ray : rays) hits.push_back(closest(ray, traversal));
        return hits;
    }

    /// Whether there is any hit of each of several rays, in their order: the answers of occluded().
    virtual std::vector<bool> occluded_of(std::span<const Ray> rays, Traversal& traversal) const {
        std::vector<bool> occluded_rays;
        occluded_rays.reserve(rays.size());
        for (const Ray& ray : rays) occluded_rays.push_back(occluded(ray, traversal));
        return occluded_rays;
    }

    virtual std::size_t bytes() const = 0;  // what is allocated beyond the scene's own arrays

    /// For diagrams: the structure itself, and the cells or nodes that closest() visits for a ray, in order. Both are
    /// empty for a structure without cells (a list).
    virtual Outline outline() const { return {}; }
    virtual std::vector<Visit> visits(const Ray&) const { return {}; }
};

/// How a structure is built: the same one for any number of threads. Structures that are built by one alone ignore it.
struct BuildOptions {
    int threads = 1;  // 0: all cores
};

/// Builds a structure by the name that `--accelerator` takes; "auto" chooses one that suits the scene. It throws an
/// Error that lists the known names. The scene must outlive the structure.
std::unique_ptr<Accelerator> make_accelerator(const std::string& name, const Scene& scene,
                                              const BuildOptions& options = {});

/// The names that make_accelerator() knows, "auto" last.
std::vector<std::string> accelerator_names();

/// The same names in one line for a help text: "list, boxed_list, ..., auto".
std::string accelerator_list();

}  // namespace raylab
