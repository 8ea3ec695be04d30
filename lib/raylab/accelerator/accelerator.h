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

/// What stopped the last ray to a light, as a structure numbers its primitives: it is asked first about the next one,
/// which mostly starts nearby and is stopped by the same. (Haines and Greenberg, The Light Buffer, IEEE CG&A 6(9), 1986.)
using Blocker = std::optional<std::uint32_t>;

/// What finding hits took.
struct TestCounts {
    std::uint64_t primitive_tests = 0;
    std::uint64_t box_tests = 0;  // of any bounds: boxes, spheres, oriented boxes
    std::uint64_t steps = 0;      // cells or nodes visited
    std::uint64_t exact_decisions = 0;  // how often the filter left a decision to exact arithmetic

    void add(const TestCounts& other) {
        primitive_tests += other.primitive_tests;
        box_tests += other.box_tests;
        steps += other.steps;
        exact_decisions += other.exact_decisions;
    }
};

/// What belongs to the caller while rays cross the seam, one for each thread and structure: counts, and what is remembered
/// of each light's shadows. Structures stay const.
struct Traversal : TestCounts {
    std::vector<Blocker> blockers = {};  // one a light; none: rays have nothing in common
    std::size_t light = 0;               // which one the next rays go to
    Mailboxes mailboxes = {};            // chapter 10
    [[no_unique_address]] ExactArithmetic arithmetic = {};

    /// The rays asked about from now on go to this light.
    void toward(std::size_t number) {
        light = number;
        if (blockers.size() <= light) blockers.resize(light + 1);
    }

    /// Whether the light's blocker stops a ray, as `hits(number)` has it; if not, it is forgotten.
    template <class Hits>
    bool stopped_again(const Hits& hits) {
        if (blockers.empty() || !blockers[light]) return false;
        if (hits(*blockers[light])) return true;
        blockers[light].reset();
        return false;
    }
    void stopped_by(std::size_t number) {
        if (!blockers.empty()) blockers[light] = static_cast<std::uint32_t>(number);
    }
};

/// The seam: every structure answers the same question, so all give the same answer: the same primitive and the same
/// bits of t, for every ray. Among hits at equal t the lowest primitive wins. A ray whose direction is zero hits nothing.
class Accelerator {
public:
    virtual ~Accelerator() = default;
    virtual std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const = 0;  // nearest hit inside ray.range
    virtual bool occluded(const Ray& ray, Traversal& traversal) const = 0;               // any hit inside ray.range

    /// The nearest hit of each of several rays, in their order: the same answers. Neighbours may share work.
    virtual std::vector<std::optional<Hit>> closest_of(std::span<const Ray> rays, Traversal& traversal) const {
        std::vector<std::optional<Hit>> hits;
        hits.reserve(rays.size());
        for (const Ray& ray : rays) hits.push_back(closest(ray, traversal));
        return hits;
    }

    virtual std::size_t bytes() const = 0;  // allocated beyond the scene's own arrays

    /// For diagrams: the structure as it stands, and the cells or nodes that closest() visits for a ray, in order. Both are
    /// empty where there is none (a list).
    virtual Outline outline() const { return {}; }
    virtual std::vector<Visit> visits(const Ray&) const { return {}; }
};

/// By name, as `--accelerator` has it, or "auto": what suits the scene. Error names the known ones. The scene must outlive
/// the structure.
std::unique_ptr<Accelerator> make_accelerator(const std::string& name, const Scene& scene);

/// The names it knows, "auto" last.
std::vector<std::string> accelerator_names();

/// "list, boxed_list, ..., auto", for a help text.
std::string accelerator_list();

}  // namespace raylab
