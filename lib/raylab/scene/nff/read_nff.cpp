#include "raylab/scene/nff/read_nff.h"

#include "raylab/base/error.h"

namespace raylab {

Scene read_nff(std::string_view, const std::string& file) { throw Error({file}, "a TOML scene", "NFF, not read yet"); }

}  // namespace raylab
