#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace raylab::grading {

/// The names of functions and variables by which an object file is linked, as C++ writes them.
struct Symbols {
    std::vector<std::string> defined;  // that no other file may define, too
    std::vector<std::string> shared;   // that each file may define which needs them: inline functions and templates
    std::vector<std::string> needed;   // that another file has to define
};

/// It throws an Error where there is no object file that nm can read.
Symbols symbols_of(const std::filesystem::path& object);

/// What is wrong with the symbols of an answer, a sentence each: it does not define the slot, or it calls a function of
/// the library, which might be the answer; what an answer needs of the library is in its headers. The harness is the
/// object that holds all of the library that an answer is linked with: of what is not in it the linker says so.
std::vector<std::string> faults_of(const Symbols& symbols, const std::string& slot,
                                   const std::filesystem::path& harness);

}  // namespace raylab::grading
