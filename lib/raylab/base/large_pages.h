#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

namespace raylab {

/// The size of a large page on x86-64 and most others; elsewhere there is no gain.
inline constexpr std::size_t large_page = std::size_t{1} << 21;

/// Allocates memory with this alignment; for half a large page and more it asks the system for large pages. Throws
/// bad_alloc.
void* allocate_on_large_pages(std::size_t bytes, std::size_t alignment);
void free_from_large_pages(void* memory);

/// An allocator for arrays that are read at random places: with pages of 4 KB almost every access needs an address
/// translation that is not cached; with pages of 2 MB few do (a tenth of the time of incoherent rays through a million
/// triangles).
template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class Other>
    LargePages(const LargePages<Other>&) {}

    T* allocate(std::size_t count) {
        if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
        return static_cast<T*>(allocate_on_large_pages(count * sizeof(T), alignof(T)));
    }
    void deallocate(T* memory, std::size_t) { free_from_large_pages(memory); }

    friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

struct FreeFromLargePages {
    void operator()(void* memory) const { free_from_large_pages(memory); }
};

/// An array of trivial elements that are not set, for what is written before it is read. Each small page of it would
/// be asked for by a fault, which takes 2 to 11 microseconds in a virtual machine.
template <class T>
using LargeArray = std::unique_ptr<T[], FreeFromLargePages>;

/// Throws bad_alloc, or bad_array_new_length where so many elements have no addresses.
template <class T>
LargeArray<T> large_array(std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T>);
    T* const first = LargePages<T>().allocate(count);
    std::uninitialized_default_construct_n(first, count);
    return LargeArray<T>(first);
}

}  // namespace raylab
