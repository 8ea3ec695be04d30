#pragma once

#include <filesystem>

namespace raylab::grading {

/// Fills a folder with what a course gives out: program, launcher and harnesses as this build made them, each
/// exercise's stub, README and hints, the headers that answers may include, the lessons. No source of a reference is in
/// it, and no mistake; the reference is in the program alone, without its symbols, which has to judge. The folder may
/// be moved.
void write_handout(const std::filesystem::path& folder);

}  // namespace raylab::grading
