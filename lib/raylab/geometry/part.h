#pragma once

namespace raylab {

/// Which part of a surface of revolution is hit; every other shape is all side.
enum class Part { side = 0, base_cap = 1, top_cap = 2 };

}  // namespace raylab
