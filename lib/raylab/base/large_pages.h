#pragma once

#include <cstddef>
#include <new>
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

/// The same, but elements that are made without a value are not set.
template <class T>
struct UnsetLargePages : LargePages<T> {
    UnsetLargePages() = default;
    template <class Other>
    UnsetLargePages(const UnsetLargePages<Other>&) {}

    void construct(T* at) { new (at) T; }
};

/// For what is written before it is read. Each page is asked for by the thread that writes there first, by a fault:
/// small ones take 2 to 11 microseconds in a virtual machine, large ones up to 1500.
template <class T>
using LargeArray = std::vector<T, UnsetLargePages<T>>;

}  // namespace raylab
