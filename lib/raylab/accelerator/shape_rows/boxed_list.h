#pragma once

#include "raylab/accelerator/shape_rows/row_questions.h"
#include "raylab/accelerator/shape_rows/shape_rows.h"
#include "raylab/geometry/filter/sphere_filter.h"

#include <optional>
#include <vector>

namespace raylab {

/// For a handful of primitives: a list, but doubles say of all of them at once which a ray surely misses, spheres by
/// their equation and all others by their boxes.
class BoxedList final : public Accelerator {
public:
    explicit BoxedList(const Scene& scene);

    std::optional<Hit> closest(const Ray& ray, Traversal& traversal) const override;
    bool occluded(const Ray& ray, Traversal& traversal) const override;
    std::size_t bytes() const override {
        return primitives_.bytes() + rows_.capacity() * sizeof(ShapeRows) + balls_.capacity() * sizeof(balls_[0]);
    }

private:
    struct Met {
        std::size_t place;
        std::optional<Candidate> found;
    };
    std::optional<Candidate> candidate(const ShapeRows& rows, std::size_t place, const Ray& ray,
                                       Traversal& traversal) const;
    void test(const ShapeRows& rows, std::uint32_t open, const RowQuestions::Entries& entries, const Ray& ray,
              Nearest& nearest, Traversal& traversal) const;
    std::optional<Hit> closest_of_open(std::uint32_t open, const RowQuestions::Entries& entries, const Ray& ray,
                                       const Met& first, Traversal& traversal) const;
    std::optional<Hit> closest_of_rows(const Ray& ray, Traversal& traversal) const;
    bool stops(const ShapeRows& rows, const Ray& ray, Traversal& traversal) const;
    bool is_shut_in(const Ray& ray) const;

    Primitives primitives_;
    std::vector<ShapeRows> rows_;
    std::vector<std::optional<sphere_filter::Ball>> balls_;  // of objects that are whole spheres
    RowQuestions ask_;
};

}  // namespace raylab
