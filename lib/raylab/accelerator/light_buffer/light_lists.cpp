#include "raylab/accelerator/light_buffer/light_lists.h"

#include "raylab/accelerator/light_buffer/light_hull.h"
#include "raylab/accelerator/primitives.h"
#include "raylab/base/tiles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace raylab {

namespace {

// The tolerance is this share of the distance to the farthest primitive. A shadow ray starts at floats and flies in a
// direction of floats: it strays by some 2^-23 of its length and of its coordinates. 64 times that allows for points
// beyond all primitives (on a plane), and is still some hundredths of a cell.
constexpr double tolerated = 0x1p-17;

constexpr float infinity = std::numeric_limits<float>::infinity();

float rounded_down(double x) {
    const float nearest = cast<float>(x);
    return nearest > x ? std::nextafter(nearest, -infinity) : nearest;
}

double farthest_corner(const Box& box, const Vec3d& from) {
    const auto reach = [&](int axis) {
        return std::max(std::abs(box.min[axis] - from[axis]), std::abs(box.max[axis] - from[axis]));
    };
    return glm::length(Vec3d{reach(0), reach(1), reach(2)});
}

// A primitive in a cell.
struct Found {
    std::uint32_t cell;
    LightLists::Entry entry;
    // What is deeper is surely in its shadow.
    float cover_depth;
};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Finds the cells in which primitives may be seen.
class Finder {
public:
    Finder(const Primitives& primitives, const Vec3d& light, const LightBufferOptions& options, double tolerance)
        : primitives_(primitives), light_(light), options_(options), tolerance_(tolerance) {}

    void add(std::uint32_t i) {
        // Twice: a way may stray so much, and a point's cell is known up to rounding only.
        const auto hull = hull_from(light_, primitives_.target(i), 2 * tolerance_);
        if (!hull) return everywhere.push_back(i);
        const Silhouette seen(*hull);
        for (int face = 0; face < 6; ++face)
            descend(i, seen, LightPyramid{face}, {0, 0, options_.resolution, CellBlock::unknown});
    }

    std::vector<Found> found;
    std::vector<std::uint32_t> everywhere;

private:
    bool is_outside(const Silhouette& seen, const LightPyramid& pyramid) const {
        return options_.listing == Listing::rectangles ? seen.is_outside_by_sides(pyramid) : seen.is_outside(pyramid);
    }

    // size x size cells from (column, row).
    struct CellBlock {
        int column, row, size;
        enum Filled { unknown, yes } filled;  // whether the shape is known to fill all of it
    };

    // From a whole face down to single cells.
    void descend(std::uint32_t i, const Silhouette& seen, const LightPyramid& pyramid, CellBlock part) {
        if (part.filled == CellBlock::unknown) {
            if (is_outside(seen, pyramid)) return;
            if (part.size > 1 && seen.cover_depth(pyramid)) part.filled = CellBlock::yes;
        }
        if (part.size == 1) return list(i, seen, pyramid, part.column, part.row);
        const int half = part.size / 2;
        const auto quarters = pyramid.quarters();
        for (int q = 0; q < 4; ++q)
            descend(i, seen, quarters[at(q)], {part.column + q % 2 * half, part.row + q / 2 * half, half, part.filled});
    }

    void list(std::uint32_t i, const Silhouette& seen, const LightPyramid& pyramid, int column, int row) {
        if (options_.listing == Listing::centers && !is_at_center(i, pyramid)) return;
        const std::size_t cell =
            (at(pyramid.face) * at(options_.resolution) + at(row)) * at(options_.resolution) + at(column);
        // A centre proves no cover.
        const auto depth = options_.listing == Listing::centers ? std::nullopt : seen.cover_depth(pyramid);
        found.push_back({static_cast<std::uint32_t>(cell),
                         {i, rounded_down(seen.min_depth(pyramid))},
                         depth ? -rounded_down(-*depth) : infinity});
    }

    bool is_at_center(std::uint32_t i, const LightPyramid& pyramid) const {
        Traversal traversal;
        return primitives_.hits(i, {convert<float>(light_), convert<float>(pyramid.center())}, traversal);
    }

    const Primitives& primitives_;
    Vec3d light_;
    LightBufferOptions options_;
    double tolerance_;
};

// Threads find the cells of some primitives each; what they found is put together in the order of the primitives.
class Builder {
public:
    Builder(const Primitives& primitives, const Vec3d& light, const LightBufferOptions& options)
        : primitives_(primitives),
          light_(light),
          options_(options),
          cells_(6 * at(options.resolution) * at(options.resolution)) {
        lists_.covers.resize(cells_);
        lists_.first.resize(cells_ + 1);
    }

    LightLists build() {
        for (std::size_t i = 0; i < primitives_.size(); ++i) {
            const auto box = primitives_.bounds(i);
            const double reach = box ? farthest_corner(*box, light_) : 0;
            if (std::isfinite(reach)) lists_.radius = std::max(lists_.radius, reach * (1 + 0x1p-50));
        }
        lists_.tolerance = lists_.radius * tolerated;
        find();
        for (const Finder& finder : finders_) cover(finder);
        list();
        sort();
        return std::move(lists_);
    }

private:
    void find() {
        constexpr std::size_t piece = 64;
        const Finder nothing_yet(primitives_, light_, options_, lists_.tolerance);
        finders_ = std::vector<Finder>((primitives_.size() + piece - 1) / piece, nothing_yet);
        for_each_piece(primitives_.size(), piece, options_.threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) finders_[begin / piece].add(static_cast<std::uint32_t>(i));
        });
    }

    void cover(const Finder& finder) {
        lists_.everywhere.insert(lists_.everywhere.end(), finder.everywhere.begin(), finder.everywhere.end());
        for (const Found& one : finder.found) {
            LightLists::Cover& cover = lists_.covers[one.cell];
            if (one.cover_depth < cover.depth) cover = {one.entry.primitive, one.cover_depth};
        }
    }

    // By cell; without what only points behind a cover could ask for.
    void list() {
        const auto for_each_found = [&](const auto& use) {
            for (const Finder& finder : finders_)
                for (const Found& one : finder.found)
                    if (!(one.entry.depth > lists_.covers[one.cell].depth)) use(one);
        };
        for_each_found([&](const Found& one) { ++lists_.first[one.cell + 1]; });
        for (std::size_t cell = 0; cell < cells_; ++cell) lists_.first[cell + 1] += lists_.first[cell];
        lists_.entries.resize(lists_.first[cells_]);
        std::vector<std::uint32_t> next(lists_.first.begin(), lists_.first.end() - 1);
        for_each_found([&](const Found& one) { lists_.entries[next[one.cell]++] = one.entry; });
    }

    // In each cell by depth.
    void sort() {
        constexpr std::size_t piece = 1024;
        const auto place = [&](std::size_t cell) { return lists_.entries.begin() + lists_.first[cell]; };
        const auto nearer = [](const LightLists::Entry& a, const LightLists::Entry& b) {
            return a.depth < b.depth || (a.depth == b.depth && a.primitive < b.primitive);
        };
        for_each_piece(cells_, piece, options_.threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t cell = begin; cell < end; ++cell) std::sort(place(cell), place(cell + 1), nearer);
        });
    }

    const Primitives& primitives_;
    Vec3d light_;
    LightBufferOptions options_;
    std::size_t cells_;
    std::vector<Finder> finders_;
    LightLists lists_;
};

}  // namespace

std::size_t LightLists::bytes() const {
    return first.capacity() * sizeof(first[0]) + entries.capacity() * sizeof(Entry) +
           covers.capacity() * sizeof(Cover) + everywhere.capacity() * sizeof(everywhere[0]);
}

double LightLists::mean_length() const {
    double sum = 0;
    for (std::size_t cell = 0; cell + 1 < first.size(); ++cell) sum += std::pow(first[cell + 1] - first[cell], 2);
    return entries.empty() ? 0 : sum / static_cast<double>(entries.size());
}

LightLists light_lists(const Primitives& primitives, const Vec3d& light, const LightBufferOptions& options) {
    assert(options.resolution > 0 && (options.resolution & (options.resolution - 1)) == 0);
    return Builder(primitives, light, options).build();
}

}  // namespace raylab
