#include "raylab/accelerator/item_buffer/item_buffer.h"

#include "raylab/base/tiles.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <span>
#include <tuple>

namespace raylab {

namespace {

// Threads share the picture by strips of so many rows: few enough that what is counted of a strip stays in a core's
// cache.
constexpr std::size_t strip_height = 64;

std::size_t pixels_of(const PictureView& view) {
    return static_cast<std::size_t>(view.size().width) * static_cast<std::size_t>(view.size().height);
}

std::size_t strips_of(const PictureView& view) {
    return (static_cast<std::size_t>(view.size().height) + strip_height - 1) / strip_height;
}

}  // namespace

// The result of drawing the primitives.
struct ItemBuffer::Drawn {
    struct Item {
        float begins;
        std::uint32_t place;            // of the primitive in scene order
        std::uint32_t first_row, rows;  // of its piece's
        int top, bottom;                // of its rows, and before which they end
    };

    // What is drawn of some primitives: of each its rows, from top to bottom.
    struct Piece {
        std::vector<PictureRow> rows;
        std::vector<Item> items;
        std::vector<Primitive> always;
        std::vector<std::uint32_t> in_strips;  // how many items the pixels of each strip get

        // Draws a primitive, and returns through how many pixels it may be seen.
        std::size_t draw(const Scene& scene, Primitive primitive, const PictureView& view, std::uint32_t place) {
            if (const auto box = bounds_of(scene, primitive)) {
                const PictureRows found(view, picture_hull(view, target_of(scene, primitive), *box));
                if (!found.everywhere()) return add(found, place);
            }
            always.push_back(primitive);
            return 0;
        }

    private:
        std::size_t add(const PictureRows& found, std::uint32_t place) {
            const std::size_t before = rows.size();
            std::size_t pixels = 0;
            found.for_each([&](const PictureRow& row) {
                rows.push_back(row);
                const std::uint32_t count = static_cast<std::uint32_t>(row.last - row.first) + 1;
                in_strips[static_cast<std::size_t>(row.row) / strip_height] += count;
                pixels += count;
            });
            const std::size_t count = rows.size() - before;
            if (count > 0)
                items.push_back({rounded_down(found.begins()), place, static_cast<std::uint32_t>(before),
                                 static_cast<std::uint32_t>(count), rows[before].row, rows.back().row + 1});
            return pixels;
        }

        static float rounded_down(double begins) {
            constexpr double largest = std::numeric_limits<float>::max();
            return cast<float>(std::min(begins * PictureView::below, largest));
        }
    };

    static constexpr std::size_t grain = 256;                                     // primitives a piece
    static constexpr auto max_items = std::numeric_limits<std::uint32_t>::max();  // of all pixels

    std::vector<Primitive> primitives;
    std::vector<Piece> pieces;
    std::vector<Item> items;  // the nearest first
    std::vector<Primitive> always;
    bool too_many = false;

    Drawn(const Scene& scene, const PictureView& view, int threads) : primitives(primitives_of(scene)) {
        pieces.resize((primitives.size() + grain - 1) / grain);
        const std::size_t most = std::min(max_per_pixel * pixels_of(view), std::size_t{max_items});
        std::atomic<std::size_t> drawn = 0;
        for_each_piece(primitives.size(), grain, threads, [&](std::size_t begin, std::size_t end) {
            Piece& piece = pieces[begin / grain];
            piece.in_strips.resize(strips_of(view));
            std::size_t own = 0;
            for (std::size_t place = begin; place < end && drawn + own <= most; ++place)
                own += piece.draw(scene, primitives[place], view, static_cast<std::uint32_t>(place));
            drawn += own;
        });
        too_many = drawn > most;
        if (too_many) return;
        std::size_t count = 0;
        for (const Piece& one : pieces) count += one.items.size();
        items.reserve(count);
        for (const Piece& one : pieces) {
            items.insert(items.end(), one.items.begin(), one.items.end());
            always.insert(always.end(), one.always.begin(), one.always.end());
        }
        std::ranges::sort(items, {}, [](const Item& item) { return std::tuple(item.begins, item.place); });
    }

    std::vector<Primitive> seen() const {
        std::vector<Primitive> names;
        names.reserve(items.size());
        for (const Item& item : items) names.push_back(primitives[item.place]);
        return names;
    }

    // How many items the pixels above each strip get, and in the end those of all.
    std::vector<std::uint32_t> items_above(std::size_t strips) const {
        std::vector<std::uint32_t> above(strips + 1);
        for (std::size_t i = 0; i < strips; ++i) {
            above[i + 1] = above[i];
            for (const Piece& one : pieces) above[i + 1] += one.in_strips[i];
        }
        return above;
    }

    // Calls at(number of the item, its row) for what is drawn in the picture's rows from top to before bottom, the
    // farthest item first.
    template <class At>
    void for_each_between(int top, int bottom, const At& at) const {
        for (auto i = static_cast<std::uint32_t>(items.size()); i-- > 0;) {
            const Item& item = items[i];
            if (item.top >= bottom || item.bottom <= top) continue;
            const std::span own = std::span(pieces[item.place / grain].rows).subspan(item.first_row, item.rows);
            auto row = std::ranges::lower_bound(own, top, {}, &PictureRow::row);
            for (; row != own.end() && row->row < bottom; ++row) at(i, *row);
        }
    }
};

ItemBuffer::ItemBuffer(const Scene& scene, const CameraFrame& frame, const Accelerator& others,
                       const BuildOptions& build)
    : ItemBuffer(scene, PictureView(frame), others, Drawn(scene, PictureView(frame), build.threads), build.threads) {}

ItemBuffer::ItemBuffer(const Scene& scene, const PictureView& view, const Accelerator& others, const Drawn& drawn,
                       int threads)
    : view_(view), others_(others), always_(scene, drawn.always), seen_(scene, drawn.seen()) {
    if (!drawn.too_many) keep(drawn, threads);
}

void ItemBuffer::keep(const Drawn& drawn, int threads) {
    begins_.reserve(drawn.items.size());
    for (const Drawn::Item& item : drawn.items) begins_.push_back(item.begins);
    const auto above = drawn.items_above(strips_of(view_));
    first_ = LargeArray<std::uint32_t>(pixels_of(view_) + 1);
    first_[pixels_of(view_)] = above.back();
    items_ = LargeArray<std::uint32_t>(above.back());
    for_each_piece(static_cast<std::size_t>(view_.size().height), strip_height, threads,
                   [&](std::size_t top, std::size_t bottom) {
                       count(drawn, static_cast<int>(top), static_cast<int>(bottom), above[top / strip_height]);
                       put(drawn, static_cast<int>(top), static_cast<int>(bottom));
                   });
}

// Lets the pixels of a strip have the places where their items end; `sum` are above them.
void ItemBuffer::count(const Drawn& drawn, int top, int bottom, std::uint32_t sum) {
    for (int row = top; row < bottom; ++row) std::ranges::fill(pixels(whole(row)), 0u);
    // First how many more items each pixel has than the one to its left.
    drawn.for_each_between(top, bottom, [&](std::uint32_t, const PictureRow& row) {
        ++first_[view_.number(row.first, row.row)];
        if (row.last + 1 < view_.size().width) --first_[view_.number(row.last + 1, row.row)];
    });
    for (int row = top; row < bottom; ++row) {
        std::uint32_t own = 0;
        for (std::uint32_t& pixel : pixels(whole(row))) {
            own += pixel;
            sum += own;
            pixel = sum;
        }
    }
}

// Puts a strip's items. Each takes the last place that its pixels have left, so that the nearest is first, and the
// places where items end become those where they begin.
void ItemBuffer::put(const Drawn& drawn, int top, int bottom) {
    drawn.for_each_between(top, bottom, [&](std::uint32_t i, const PictureRow& row) {
        for (std::uint32_t& end : pixels(row)) items_[--end] = i;
    });
}

PictureRow ItemBuffer::whole(int row) const { return {row, 0, view_.size().width - 1}; }

std::span<std::uint32_t> ItemBuffer::pixels(const PictureRow& row) {
    return {first_.data() + view_.number(row.first, row.row), static_cast<std::size_t>(row.last - row.first) + 1};
}

std::optional<std::size_t> ItemBuffer::items(int column, int row) const {
    if (first_.empty()) return std::nullopt;
    const std::size_t pixel = view_.number(column, row);
    return always_.size() + first_[pixel + 1] - first_[pixel];
}

std::optional<Hit> ItemBuffer::closest(const Ray& ray, Traversal& traversal) const {
    const auto pixel = first_.empty() ? std::nullopt : view_.pixel(ray);
    if (!pixel) return others_.closest(ray, traversal);
    ++traversal.steps;
    Nearest nearest(ray);
    for (std::size_t i = 0; i < always_.size(); ++i) always_.test(i, ray, nearest, traversal);
    for (std::uint32_t k = first_[*pixel]; k < first_[*pixel + 1]; ++k) {
        const std::uint32_t i = items_[k];
        if (begins_[i] > nearest.limit()) break;  // and so do all that follow
        seen_.test(i, ray, nearest, traversal);
    }
    return nearest.hit();
}

bool ItemBuffer::occluded(const Ray& ray, Traversal& traversal) const { return others_.occluded(ray, traversal); }

std::size_t ItemBuffer::bytes() const {
    const std::size_t places = first_.empty() ? 0 : pixels_of(view_) + 1 + first_[pixels_of(view_)];
    return always_.bytes() + seen_.bytes() + begins_.capacity() * sizeof(float) + places * sizeof(std::uint32_t);
}

}  // namespace raylab
