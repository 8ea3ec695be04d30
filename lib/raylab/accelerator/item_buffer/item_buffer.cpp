#include "raylab/accelerator/item_buffer/item_buffer.h"

#include "raylab/accelerator/sorted_primitives.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace raylab {

// The result of drawing the primitives. Rows lie one item after the other.
struct ItemBuffer::Drawn {
    struct Item {
        double begins;
        std::uint32_t box, first_row, rows;
    };
    std::vector<PictureRow> rows;
    std::vector<Item> items;            // the nearest first
    std::vector<std::uint32_t> always;  // places in scene order
    bool too_many = false;

    Drawn(const SortedPrimitives& sorted, const PictureView& view) : always(sorted.unbounded) {
        const auto pixels = static_cast<std::size_t>(view.size().width) * static_cast<std::size_t>(view.size().height);
        std::size_t drawn = 0;
        for (std::uint32_t box = 0; box < sorted.boxes.size() && !too_many; ++box) {
            drawn += draw(sorted, view, box);
            too_many = drawn > max_per_pixel * pixels;
        }
        std::ranges::stable_sort(items, {}, &Item::begins);
        std::ranges::sort(always);
    }

    std::vector<std::uint32_t> order() const {
        std::vector<std::uint32_t> boxes;
        for (const Item& item : items) boxes.push_back(item.box);
        return boxes;
    }

private:
    // Through how many pixels the primitive may be seen.
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
        if (count > 0) items.push_back({found.begins(), box, static_cast<std::uint32_t>(before), count});
        return pixels;
    }
};

ItemBuffer::ItemBuffer(const Scene& scene, const CameraFrame& frame, const Accelerator& others)
    : ItemBuffer(SortedPrimitives(scene), frame, others) {}

ItemBuffer::ItemBuffer(const SortedPrimitives& sorted, const CameraFrame& frame, const Accelerator& others)
    : ItemBuffer(sorted, PictureView(frame), others, Drawn(sorted, PictureView(frame))) {}

ItemBuffer::ItemBuffer(const SortedPrimitives& sorted, const PictureView& view, const Accelerator& others,
                       const Drawn& drawn)
    : view_(view),
      others_(others),
      always_(sorted.all, drawn.too_many ? std::vector<std::uint32_t>{} : drawn.always),
      seen_(sorted.in_order(drawn.too_many ? std::vector<std::uint32_t>{} : drawn.order())) {
    if (!drawn.too_many) keep(drawn);
}

void ItemBuffer::keep(const Drawn& drawn) {
    const auto pixels = static_cast<std::size_t>(view_.size().width) * static_cast<std::size_t>(view_.size().height);
    first_.assign(pixels + 1, 0);
    for (const PictureRow& row : drawn.rows)
        for (int column = row.first; column <= row.last; ++column) ++first_[view_.number(column, row.row) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    items_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < drawn.items.size(); ++i) {
        const Drawn::Item& item = drawn.items[i];
        constexpr double largest = std::numeric_limits<float>::max();
        begins_.push_back(cast<float>(std::min(item.begins * PictureView::below, largest)));
        for (std::uint32_t r = item.first_row; r < item.first_row + item.rows; ++r)
            for (int column = drawn.rows[r].first; column <= drawn.rows[r].last; ++column)
                items_[next[view_.number(column, drawn.rows[r].row)]++] = i;
    }
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
    return always_.bytes() + seen_.bytes() + begins_.capacity() * sizeof(float) +
           (first_.capacity() + items_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace raylab
