#include "raylab/report/structure/structure_replay.h"

#include "fuzz/memory_file.h"
#include "fuzz/value_or_error.h"

#include <cassert>

using namespace raylab;

namespace {

StructureDifference read(std::string_view bytes) { return read_difference(MemoryFile(bytes).path()); }

// A difference that was read must not throw: noexcept ends the fuzzer if it does.
void check_difference(const StructureDifference& difference) noexcept {
    const std::string text = to_json(difference);
    assert(to_json(read(text)) == text);
    for (const std::string& name : accelerator_names())
        assert(!judge_by_list(structure_method(name))(difference.smallest));
}

}  // namespace

// Any bytes must give a difference that is written and read again unchanged, and that every structure answers as the
// list does, or an Error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return value_or_error(data, size, [](std::string_view bytes) { check_difference(read(bytes)); });
}
