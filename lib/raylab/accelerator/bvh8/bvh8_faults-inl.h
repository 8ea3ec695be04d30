// Compiled once for every instruction set (see bvh8_walk.cpp), so the include guard opens again for the next.
#if defined(RAYLAB_BVH8_FAULTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYLAB_BVH8_FAULTS_INL_H
#undef RAYLAB_BVH8_FAULTS_INL_H
#else
#define RAYLAB_BVH8_FAULTS_INL_H
#endif

#include "raylab/accelerator/bvh8/bvh8_lanes-inl.h"
#include "raylab/number/arithmetic_probe.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace raylab::HWY_NAMESPACE {

/// The arithmetic faults of the code that was compiled for this instruction set, with single numbers and with vectors.
/// (GCC may contract vector expressions like scalar ones.)
HWY_INLINE CompiledFaults faults_of_lanes() {
    const float one = unforeseen(1.0f), small = unforeseen(0x1p-12f);
    // The exact square has another 2^-24, which is rounded away.
    const Floats factor = all(one + small), square = all(one + 2 * small);
    const Floats rest = hn::Sub(hn::Mul(factor, factor), square);
    CompiledFaults faults = compiled_faults();
    faults.contracts = faults.contracts || !hn::AllTrue(lanes_tag, hn::Eq(rest, hn::Zero(lanes_tag)));
    return faults;
}

}  // namespace raylab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
