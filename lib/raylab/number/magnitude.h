#pragma once

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <utility>

namespace raylab {

/// A whole number >= 0 in the representation of GMP's mpn functions: limbs, the lowest first, the highest not zero.
/// Numbers in predicates are mostly short, and short ones are stored here without the heap, which GMP's own numbers
/// always use.
class Magnitude {
public:
    Magnitude() {}  // zero; the limbs are not initialised

    /// Makes room for this many limbs, which the caller sets and then calls trim().
    explicit Magnitude(std::size_t room) : size_(room) {
        if (room > few) heap_ = std::make_unique_for_overwrite<mp_limb_t[]>(room);
    }

    Magnitude(const Magnitude& other) : Magnitude(other.size_) {
        if (other.heap_)  // it may have few limbs now: the highest may have been zeros
            std::copy_n(other.limbs(), size_, limbs());
        else
            take_few(other);
    }
    Magnitude(Magnitude&& other) noexcept { *this = std::move(other); }
    Magnitude& operator=(const Magnitude& other) { return *this = Magnitude(other); }
    Magnitude& operator=(Magnitude&& other) noexcept {
        heap_ = std::move(other.heap_);
        size_ = std::exchange(other.size_, 0);
        if (!heap_) take_few(other);
        return *this;
    }
    ~Magnitude() = default;

    std::size_t size() const { return size_; }
    mp_size_t length() const { return static_cast<mp_size_t>(size_); }  // in mpn's type
    mp_limb_t* limbs() { return heap_ ? heap_.get() : here_.data(); }
    const mp_limb_t* limbs() const { return heap_ ? heap_.get() : here_.data(); }

    /// Removes leading zeros.
    void trim() {
        while (size_ > 0 && limbs()[size_ - 1] == 0) --size_;
    }

private:
    static constexpr std::size_t few = 12;  // 768 bits

    // Copies one of two fixed lengths, because a copy of variable length would be a function call.
    void take_few(const Magnitude& other) {
        if (size_ <= few / 3)
            std::memcpy(here_.data(), other.here_.data(), sizeof here_ / 3);
        else
            std::memcpy(here_.data(), other.here_.data(), sizeof here_);
    }

    std::unique_ptr<mp_limb_t[]> heap_;  // used for more than `few`
    std::size_t size_ = 0;
    std::array<mp_limb_t, few> here_;
};

}  // namespace raylab
