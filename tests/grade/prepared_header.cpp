#include "prepared_header.h"
#include "catch.h"

#include "compiling.h"

#include "raylab/base/file.h"
#include "raylab/base/temporary.h"
#include "raylab/report/provenance.h"

#include <filesystem>

using namespace raylab;
using namespace raylab::grading;

TEST_CASE("with a header that was compiled before an answer is the same object, and the header is not read again") {
    const auto& asked = exercise("07c");
    const auto answer = source_folder() / "exercises" / asked.folder / "right/two_amplitudes.cpp";
    const ScratchFolder prepared;
    prepare_header(asked, prepared.path());
    const auto isolation = best_isolation();
    const Workplace plain(asked, isolation), shared(asked, isolation, prepared.path());
    REQUIRE(compile(asked, plain, answer).succeeded);
    REQUIRE(compile(asked, shared, answer).succeeded);
    CHECK(read_file(plain.object()) == read_file(shared.object()));
    const auto reads_header = [&](const Workplace& workplace) {
        return read_file(workplace.dependencies()).find(declaring_header(asked)) != std::string::npos;
    };
    CHECK(reads_header(plain));
    CHECK_FALSE(reads_header(shared));
}

TEST_CASE("each exercise's stub names the header that declares its function") {
    for (const auto& asked : exercises()) {
        const auto text = read_file(source_folder() / "lib" / declaring_header(asked));
        INFO(asked.folder << ": " << declaring_header(asked));
        CHECK(text.find(asked.slot + "(") != std::string::npos);
    }
}
