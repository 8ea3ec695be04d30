#include "raylab/accelerator/shape_rows/row_questions.h"

#include "raylab/accelerator/bvh8/bvh8_instruction_set.h"

#include <cassert>

// Compiled once for every instruction set named by Highway; which one runs is decided where the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raylab/accelerator/shape_rows/row_questions.cpp"
#include <hwy/foreach_target.h>

#include "raylab/accelerator/bvh8/bvh8_faults-inl.h"
#include "raylab/accelerator/shape_rows/row_boxes-inl.h"
#include "raylab/accelerator/shape_rows/row_spheres-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

HWY_INLINE std::uint32_t first(std::size_t count) {
    return static_cast<std::uint32_t>((std::uint64_t{1} << count) - 1);
}

HWY_INLINE std::uint32_t open_boxes(const ShapeRows& rows, const RowBoxes& boxes, double* entries) {
    std::uint32_t hit_found = 0;
    for (std::size_t i = 0; i < rows.box_count; i += doubles_at_once)
        hit_found |= bits(doubles_tag, boxes.hit_mask(i, entries)) << i;
    return hit_found & first(rows.box_count);
}

// Spheres are asked first; their places end where those of boxes begin. (Where a sphere is entered is not asked: to
// test one takes no more than that.)
std::uint32_t open(const ShapeRows& rows, const Ray& ray, double end, RowQuestions::Entries& entries) {
    const RowRay row_ray(ray);
    std::uint32_t missed = 0;
    if (rows.sphere_count != 0) {
        const RowSpheres spheres(row_ray);
        for (std::size_t i = 0; i < rows.sphere_count; i += doubles_at_once) {
            missed |= bits(doubles_tag, spheres.along(rows.spheres, i).missed()) << i;
            hn::StoreU(hn::Zero(doubles_tag), doubles_tag, entries.data() + i);
        }
    }
    const std::uint32_t spheres = ~missed & first(rows.sphere_count);
    if (rows.box_count == 0) return spheres;
    const RowBoxes boxes(rows, row_ray, ray, end);
    return spheres | open_boxes(rows, boxes, entries.data() + rows.sphere_count) << rows.sphere_count;
}

RowQuestions::Stops stops(const ShapeRows& rows, const Ray& ray) {
    const RowRay row_ray(ray);
    const RowSpheres spheres(row_ray);
    std::uint32_t missed = 0, sure = 0;
    for (std::size_t i = 0; i < rows.sphere_count; i += doubles_at_once) {
        const SpheresAlong s = spheres.along(rows.spheres, i);
        sure |= bits(doubles_tag, spheres.entered(s, ray.range.max)) << i;
        missed |= bits(doubles_tag, s.missed()) << i;
    }
    const std::uint32_t those = first(rows.sphere_count);
    RowQuestions::Stops found{~missed & those, ray.range.min > 0 ? 0 : sure & those};
    if (found.sure != 0 || rows.box_count == 0) return found;
    RowQuestions::Entries entries;
    const RowBoxes boxes(rows, row_ray, ray, ray.range.max);
    found.open |= open_boxes(rows, boxes, entries.data()) << rows.sphere_count;
    return found;
}

CompiledFaults row_faults() { return faults_of_lanes(); }

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace raylab {

HWY_EXPORT(open);
HWY_EXPORT(stops);
HWY_EXPORT(row_faults);

RowQuestions best_row_questions() {
    const std::size_t best = best_instruction_set();
    const RowQuestions questions{HWY_DISPATCH_TABLE(open)[best], HWY_DISPATCH_TABLE(stops)[best],
                                 HWY_DISPATCH_TABLE(row_faults)[best]};
    assert(questions.faults() == CompiledFaults{} && "row_questions.cpp is compiled with cmake/flags.cmake's flags");
    return questions;
}

}  // namespace raylab
#endif
