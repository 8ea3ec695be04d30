#include "fuzz/any_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return read_any_mesh(data, size, raylab::MeshFormat::off);
}
