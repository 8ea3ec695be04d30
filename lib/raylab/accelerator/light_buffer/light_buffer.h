#pragma once

#include "raylab/accelerator/accelerator.h"
#include "raylab/accelerator/light_buffer/light_cell.h"
#include "raylab/accelerator/light_buffer/light_lists.h"

#include <memory>
#include <optional>
#include <span>

namespace raylab {

/// A cube of cells about one light, each with what may stop rays to the light there. It answers one question about one
/// kind of rays, so it does not stand behind the seam. (Haines and Greenberg, The Light Buffer: A Shadow-Testing
/// Accelerator, IEEE CG&A 6(9), 1986; chapter 08.)
class LightBuffer {
public:
    LightBuffer(const Scene& scene, const Vec3d& light, const LightBufferOptions& options = {});
    LightBuffer(std::shared_ptr<const Primitives> primitives, const Vec3d& light,
                const LightBufferOptions& options = {});

    /// Whether something stops the ray. Absent: it does not go to this light, as far as floats can, and nothing is
    /// known.
    std::optional<bool> occluded(const Ray& ray, Traversal& traversal) const;

    const Vec3d& light() const { return light_; }
    int resolution() const { return options_.resolution; }
    std::span<const LightLists::Entry> list(const LightCell& cell) const;
    const LightLists::Cover& cover(const LightCell& cell) const { return lists_.covers[*index(cell)]; }
    double mean_length() const { return lists_.mean_length(); }  // of its lists
    Primitive primitive(std::uint32_t place) const;              // of an entry
    std::size_t bytes() const { return lists_.bytes(); }         // without the primitives

private:
    /// The straight way from a point to the light, and whether a ray along it ends at the light.
    struct Way {
        Vec3d from_light;
        double depth;
        enum class Ends { at_light, before } ends;
    };
    std::optional<Way> way(const Ray& ray) const;
    std::optional<std::size_t> index(const LightCell& cell) const;
    std::optional<bool> stopped(const Ray& ray, const Way& way, std::size_t cell, Traversal& traversal) const;

    std::shared_ptr<const Primitives> primitives_;
    Vec3d light_;
    LightBufferOptions options_;
    LightLists lists_;
};

}  // namespace raylab
