#pragma once

#include "raylab/accelerator/item_buffer/picture_rows.h"
#include "raylab/accelerator/primitives.h"
#include "raylab/base/large_pages.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace raylab {

/// First-hit speed-up: what may be seen through each pixel of a picture, the nearest first, found by drawing the
/// primitives instead of tracing rays (Weghorst, Hooper and Greenberg, Improved Computational Methods for Ray Tracing,
/// ACM TOG 3(1), 1984). They kept the one item that was nearest, by the z-buffer's rounded numbers; here every item is
/// kept that a ray through the closed pixel may hit, rounding included, and the ray itself decides, exactly.
///
/// It stands before another structure, which is asked about all rays that are not the camera's.
class ItemBuffer final : public Accelerator {
public:
    ItemBuffer(const Scene& scene, const CameraFrame& frame, const Accelerator& others, const BuildOptions& build = {});

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override;  // beyond those of the structure behind it
    Outline outline() const override { return others_.outline(); }
    std::vector<Visit> visits(const Ray& ray) const override { return others_.visits(ray); }

    /// How many items may be seen through a pixel; absent: there would be too many altogether, and none are kept.
    std::optional<std::size_t> items(int column, int row) const;

    /// More than this for each pixel, on average, are not kept: the structure behind is asked about every ray.
    static constexpr std::size_t max_per_pixel = 256;

private:
    struct Drawn;
    ItemBuffer(const Scene& scene, const PictureView& view, const Accelerator& others, const Drawn& drawn, int threads);

    void keep(const Drawn& drawn, int threads);
    void count(const Drawn& drawn, int top, int bottom, std::uint32_t sum);
    void put(const Drawn& drawn, int top, int bottom);
    PictureRow whole(int row) const;
    std::span<std::uint32_t> pixels(const PictureRow& row);  // of `first_`

    PictureView view_;
    const Accelerator& others_;
    Primitives always_;          // planes, and what is too near to say where in the picture it is
    Primitives seen_;            // the nearest first
    std::vector<float> begins_;  // of `seen_`: where along any eye ray it does, at the earliest
    // (Arrays that are not set before threads fill them.)
    LargeArray<std::uint32_t> first_;  // of a pixel's items; the next pixel's first one ends them; none: too many
    LargeArray<std::uint32_t> items_;  // ascending
};

}  // namespace raylab
