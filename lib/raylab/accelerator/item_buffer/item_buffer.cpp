#include "raylab/accelerator/item_buffer/item_buffer.h"

#include "raylab/accelerator/sorted_primitives.h"
#include "raylab/base/tiles.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>
#include <span>

namespace raylab {

namespace {

std::size_t pixels_of(const PictureView& view) {
    return static_cast<std::size_t>(view.size().width) * static_cast<std::size_t>(view.size().height);
}

}  // namespace

// The result of drawing the primitives.
struct ItemBuffer::Drawn {
    struct Item {
        double begins;
        std::uint32_t box, first_row, rows;
        int top, bottom;  // of its rows, and before which they end
    };

    // What is drawn of some primitives: of each its rows, from top to bottom.
    struct Piece {
        std::vector<PictureRow> rows;
        std::vector<Item> items;
        std::vector<std::uint32_t> always;  // places in scene order

        // Draws a primitive, and returns through how many pixels it may be seen.
        std::size_t draw(const SortedPrimitives& sorted, const PictureView& view, std::uint32_t box) {
            const std::uint32_t place = sorted.bounded[box];
            const PictureRows found(view, picture_hull(view, sorted.all.target(place), sorted.boxes[box]));
            if (found.everywhere()) {
                always.push_back(place);
                return 0;
            }
            const std::size_t before = rows.size();
            std::size_t pixels = 0;
            found.for_each([&](const PictureRow& row) {
                rows.push_back(row);
                pixels += static_cast<std::size_t>(row.last - row.first) + 1;
            });
            const auto count = static_cast<std::uint32_t>(rows.size() - before);
            if (count > 0)
                items.push_back({found.begins(), box, static_cast<std::uint32_t>(before), count, rows[before].row,
                                 rows.back().row + 1});
            return pixels;
        }
    };

    static constexpr std::size_t grain = 256;                                     // primitives a piece
    static constexpr auto max_items = std::numeric_limits<std::uint32_t>::max();  // of all pixels

    std::vector<Piece> pieces;
    std::vector<Item> items;  // the nearest first
    std::vector<std::uint32_t> always;
    bool too_many = false;

    Drawn(const SortedPrimitives& sorted, const PictureView& view, int threads) : always(sorted.unbounded) {
        pieces.resize((sorted.boxes.size() + grain - 1) / grain);
        const std::size_t most = std::min(max_per_pixel * pixels_of(view), std::size_t{max_items});
        std::atomic<std::size_t> drawn = 0;
        for_each_piece(sorted.boxes.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t box = begin; box < end && drawn <= most; ++box)
                drawn += pieces[begin / grain].draw(sorted, view, static_cast<std::uint32_t>(box));
        });
        too_many = drawn > most;
        if (too_many) return;
        for (const Piece& one : pieces) {
            items.insert(items.end(), one.items.begin(), one.items.end());
            always.insert(always.end(), one.always.begin(), one.always.end());
        }
        std::ranges::stable_sort(items, {}, &Item::begins);
        std::ranges::sort(always);
    }

    std::vector<std::uint32_t> order() const {
        std::vector<std::uint32_t> boxes;
        for (const Item& item : items) boxes.push_back(item.box);
        return boxes;
    }

    // Calls at(number of the item, its row) for what is drawn in the picture's rows from top to before bottom, the
    // farthest item first.
    template <class At>
    void for_each_between(int top, int bottom, const At& at) const {
        for (auto i = static_cast<std::uint32_t>(items.size()); i-- > 0;) {
            const Item& item = items[i];
            if (item.top >= bottom || item.bottom <= top) continue;
            const std::span own = std::span(pieces[item.box / grain].rows).subspan(item.first_row, item.rows);
            auto row = std::ranges::lower_bound(own, top, {}, &PictureRow::row);
            for (; row != own.end() && row->row < bottom; ++row) at(i, *row);
        }
    }
};

ItemBuffer::ItemBuffer(const Scene& scene, const CameraFrame& frame, const Accelerator& others,
                       const BuildOptions& build)
    : ItemBuffer(SortedPrimitives(scene, build.threads), frame, others, build.threads) {}

ItemBuffer::ItemBuffer(const SortedPrimitives& sorted, const CameraFrame& frame, const Accelerator& others, int threads)
    : ItemBuffer(sorted, PictureView(frame), others, Drawn(sorted, PictureView(frame), threads), threads) {}

ItemBuffer::ItemBuffer(const SortedPrimitives& sorted, const PictureView& view, const Accelerator& others,
                       const Drawn& drawn, int threads)
    : view_(view),
      others_(others),
      always_(sorted.all, drawn.too_many ? std::vector<std::uint32_t>{} : drawn.always),
      seen_(sorted.in_order(drawn.too_many ? std::vector<std::uint32_t>{} : drawn.order())) {
    if (!drawn.too_many) keep(drawn, threads);
}

// Threads share the picture by strips of rows: few enough that what is counted of a strip stays in a core's cache.
void ItemBuffer::keep(const Drawn& drawn, int threads) {
    for (const Drawn::Item& item : drawn.items) {
        constexpr double largest = std::numeric_limits<float>::max();
        begins_.push_back(cast<float>(std::min(item.begins * PictureView::below, largest)));
    }
    constexpr std::size_t rows = 64;
    const auto height = static_cast<std::size_t>(view_.size().height);
    first_.resize(pixels_of(view_) + 1);
    std::vector<std::uint32_t> before((height + rows - 1) / rows + 1);  // how many items the strips before it have
    for_each_piece(height, rows, threads, [&](std::size_t top, std::size_t bottom) {
        before[top / rows] = count(drawn, static_cast<int>(top), static_cast<int>(bottom));
    });
    std::exclusive_scan(before.begin(), before.end(), before.begin(), std::uint32_t{0});
    first_.back() = before.back();
    items_.resize(before.back());
    for_each_piece(height, rows, threads, [&](std::size_t top, std::size_t bottom) {
        put(drawn, static_cast<int>(top), static_cast<int>(bottom), before[top / rows]);
    });
}

// Lets the pixels of a strip have the places where their items end, counted from the strip's first, and returns how
// many there are.
std::uint32_t ItemBuffer::count(const Drawn& drawn, int top, int bottom) {
    for (int row = top; row < bottom; ++row) std::ranges::fill(pixels(whole(row)), Place(0));
    // First how many more items each pixel has than the one to its left.
    drawn.for_each_between(top, bottom, [&](std::uint32_t, const PictureRow& row) {
        ++first_[view_.number(row.first, row.row)].value;
        if (row.last + 1 < view_.size().width) --first_[view_.number(row.last + 1, row.row)].value;
    });
    std::uint32_t sum = 0;
    for (int row = top; row < bottom; ++row) {
        std::uint32_t own = 0;
        for (Place& pixel : pixels(whole(row))) {
            own += pixel.value;
            sum += own;
            pixel.value = sum;
        }
    }
    return sum;
}

// Puts a strip's items, before which there are so many. Each takes the last place that its pixels have left, so that
// the nearest is first, and the places where items end become those where they begin.
void ItemBuffer::put(const Drawn& drawn, int top, int bottom, std::uint32_t before) {
    for (int row = top; row < bottom; ++row)
        for (Place& end : pixels(whole(row))) end.value += before;
    drawn.for_each_between(top, bottom, [&](std::uint32_t i, const PictureRow& row) {
        for (Place& end : pixels(row)) items_[--end.value] = i;
    });
}

PictureRow ItemBuffer::whole(int row) const { return {row, 0, view_.size().width - 1}; }

std::span<ItemBuffer::Place> ItemBuffer::pixels(const PictureRow& row) {
    return std::span(first_).subspan(view_.number(row.first, row.row),
                                     static_cast<std::size_t>(row.last - row.first) + 1);
}

std::optional<std::size_t> ItemBuffer::items(int column, int row) const {
    if (first_.empty()) return std::nullopt;
    const std::size_t pixel = view_.number(column, row);
    return always_.size() + first_[pixel + 1].value - first_[pixel].value;
}

std::optional<Hit> ItemBuffer::closest(const Ray& ray, Traversal& traversal) const {
    const auto pixel = first_.empty() ? std::nullopt : view_.pixel(ray);
    if (!pixel) return others_.closest(ray, traversal);
    ++traversal.steps;
    Nearest nearest(ray);
    for (std::size_t i = 0; i < always_.size(); ++i) always_.test(i, ray, nearest, traversal);
    for (std::uint32_t k = first_[*pixel].value; k < first_[*pixel + 1].value; ++k) {
        const std::uint32_t i = items_[k].value;
        if (begins_[i] > nearest.limit()) break;  // and so do all that follow
        seen_.test(i, ray, nearest, traversal);
    }
    return nearest.hit();
}

bool ItemBuffer::occluded(const Ray& ray, Traversal& traversal) const { return others_.occluded(ray, traversal); }

std::size_t ItemBuffer::bytes() const {
    return always_.bytes() + seen_.bytes() + begins_.capacity() * sizeof(float) +
           (first_.capacity() + items_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace raylab
