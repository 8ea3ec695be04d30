#pragma once

#include "raylab/accelerator/grid/grid_planes.h"
#include "raylab/accelerator/primitives.h"

#include <cstdint>
#include <span>
#include <vector>

namespace raylab {

class GridWalk;
struct SortedPrimitives;

/// How a ray remembers what it has been tested against.
enum class MailboxKind { none, ray_id, small_cache };

struct GridOptions {
    double density = 8;  // cells a primitive: chapter 10's chart is flat about it
    MailboxKind mailboxes = MailboxKind::none;
};

/// Space in equal boxes, each with a list of the primitives that may reach into it. What has no bounds stays in a list
/// beside it, and so does everything where no grid can be cut.
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
    std::size_t entries() const { return inside_.size(); }  // over all cells

private:
    Grid(const SortedPrimitives& sorted, const GridOptions& options);

    /// Lists primitive i in those cells of ranges[i] that it may reach into.
    void fill(std::span<const GridPlanes::Range> ranges);
    std::span<const std::uint32_t> in_cell(std::size_t index) const;
    bool is_empty(std::size_t index) const { return !(occupied_[index / 64] >> (index % 64) & 1); }

    /// The nearest hit; `record(index, tests)` hears of every cell.
    template <class Before, class Record>
    std::optional<Hit> nearest(const Ray& ray, Traversal& traversal, Before& before, const Record& record) const;
    template <class Before>
    bool hits_any(const Ray& ray, Traversal& traversal, Before& before) const;
    /// Calls `ask` with what the options remember by.
    template <class Ask>
    auto with_mailboxes(Traversal& traversal, const Ask& ask) const;

    MailboxKind mailboxes_;
    GridPlanes planes_;
    LargeVector<std::uint32_t> first_;       // of each cell in inside_, and the end
    LargeVector<std::uint32_t> inside_;      // cell by cell, places in bounded_
    std::vector<std::uint64_t> occupied_;    // a bit a cell: most are empty, and this fits into the cache
    Primitives bounded_, everywhere_;        // everywhere_: tested against every ray
};

}  // namespace raylab
