#pragma once

#include "raylab/number/scalar.h"

#include <optional>

namespace raylab {

enum class Sign { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign sign) { return static_cast<Sign>(-static_cast<int>(sign)); }

constexpr Sign operator*(Sign a, Sign b) { return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b)); }

template <Real T>
constexpr Sign sign(T x) {
    if (x > 0) return Sign::positive;
    return x < 0 ? Sign::negative : Sign::zero;
}

/// Takes the signs on which a predicate depends, so that one source serves every Scalar: first the filter, then exact
/// numbers. Where T does not decide a sign, of() answers zero and the answer of the whole predicate is invalid: call
/// undecided() at its end.
template <Scalar T>
class Signs {
public:
    Sign of(const T& x) {
        const std::optional<Sign> known = sign(x);
        undecided_ = undecided_ || !known;
        return known.value_or(Sign::zero);
    }
    bool undecided() const { return undecided_; }

private:
    bool undecided_ = false;
};

}  // namespace raylab
