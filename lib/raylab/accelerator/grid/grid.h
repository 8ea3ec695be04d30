#pragma once

#include "raylab/accelerator/grid/grid_planes.h"
#include "raylab/accelerator/primitives.h"

#include <cstdint>
#include <span>
#include <vector>

namespace raylab {

class GridWalk;
struct SortedPrimitives;

/// How a ray remembers the primitives that it has been tested against.
enum class MailboxKind { none, ray_id, small_cache };

struct GridOptions {
    // Cells for each primitive; in chapter 10's chart the time hardly depends on it near this value.
    double density = 8;
    MailboxKind mailboxes = MailboxKind::none;
};

/// A uniform grid: equal boxes, each with a list of the primitives that may reach into it. Unbounded primitives stay in
/// a list beside it, and so do all primitives where no grid is possible.
class Grid final : public Accelerator {
public:
    explicit Grid(const Scene& scene, const GridOptions& options = {});

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override;
    Outline outline() const override;
    std::vector<Visit> visits(const Ray& ray) const override;

    const GridPlanes& planes() const { return planes_; }
    std::size_t primitives() const { return bounded_.size(); }
    std::size_t entries() const { return inside_.size(); }  // summed over all cells

private:
    Grid(const SortedPrimitives& sorted, const GridOptions& options);

    /// Lists each primitive i in those cells of ranges[i] that it may reach into.
    void fill(std::span<const GridPlanes::Range> ranges);
    std::span<const std::uint32_t> in_cell(std::size_t index) const;
    bool is_empty(std::size_t index) const { return !(occupied_[index / 64] >> (index % 64) & 1); }

    /// The nearest hit; `record(index, tests)` is called for every cell.
    template <class Before, class Record>
    std::optional<Hit> nearest(const Ray& ray, Traversal& traversal, Before& before, const Record& record) const;
    template <class Before>
    bool hits_any(const Ray& ray, Traversal& traversal, Before& before) const;
    /// Calls `ask` with the kind of mailboxes that the options name.
    template <class Ask>
    auto with_mailboxes(Traversal& traversal, const Ask& ask) const;

    MailboxKind mailboxes_;
    GridPlanes planes_;
    LargeVector<std::uint32_t> first_;   // where each cell's entries begin in inside_, and the end
    LargeVector<std::uint32_t> inside_;  // cell by cell, places in bounded_
    // One bit for each cell: most cells are empty, and the bits fit into the cache.
    std::vector<std::uint64_t> occupied_;
    Primitives bounded_, everywhere_;  // everywhere_ is tested against every ray
};

}  // namespace raylab
