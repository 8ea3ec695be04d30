#pragma once

#include <cstdint>
#include <string>

namespace raylab {

/// The lab book's page of typical mistakes: for every exercise each recorded mistake in all its codes, how many cases
/// tell it, and which hint it gets; and whether right answers of other shapes pass. All of them are judged now, with
/// the cases of this seed, by so many threads (0: all cores).
std::string mistakes_page(std::uint64_t seed, int threads);

}  // namespace raylab
