#pragma once

#include "raylab/geometry/bounds/box.h"
#include "raylab/geometry/ray.h"
#include "raylab/number/enclosure.h"
#include "raylab/scene/scene.h"

#include <optional>
#include <vector>

// Shadows as they are, whatever way of casting shadow rays is judged by them: the straight way from the exact point
// where a ray hit a surface to a light. No shadow ray is started, so nothing depends on where one starts.

namespace raylab {

enum class Shade { lit, blocked };

/// A ray, what it hit first, and a light on the ray's side of that surface.
struct ShadowQuestion {
    Ray arrived;
    Hit hit;
    Vec3d light;
};

class ShadowOracle {
public:
    /// How far beside the exact point, and beside the light, an answer may be the right one, in units in the last place
    /// of the largest coordinate (as floats): wherever a shadow ray starts, it starts at floats.
    static constexpr double band_ulps = 3;

    /// For scenes at rest: a light's way has no time, and those who ask build a stage of their own, on which nothing
    /// moves.
    explicit ShadowOracle(const Scene& scene);

    /// The shade of every point within the band, by enclosures; absent: an edge of a shadow may pass there.
    std::optional<Shade> around(const ShadowQuestion& question) const;

    /// The shade of the exact point. (oracle.h decides; the point is rounded to doubles, 2^29 times finer than the
    /// band.)
    Shade at(const ShadowQuestion& question) const;

    /// Whether the oracle finds both shades among points of the band, on the light's side of the surface, and about the
    /// light.
    bool edge_passes(const ShadowQuestion& question) const;

private:
    struct BoxedPrimitive {
        Primitive primitive;
        std::optional<Box> box;  // absent: unbounded
    };
    struct Segment;
    struct Way;

    Segment segment(const ShadowQuestion& question, double band_in_ulps) const;
    std::optional<Shade> around(const Segment& way) const;
    std::optional<Sides> stopping(const Segment& segment, Primitive primitive) const;
    static bool may_hit(const Segment& segment, const BoxedPrimitive& part);
    Shade at(const Segment& segment, const Way& way) const;
    bool blocks(const Segment& segment, const Way& way, Primitive primitive) const;
    std::optional<bool> surely_blocks(const Segment& segment, Primitive primitive) const;

    const Scene& scene_;
    std::vector<BoxedPrimitive> parts_;
};

}  // namespace raylab
