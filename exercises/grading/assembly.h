#pragma once

#include <string>
#include <vector>

namespace raylab::grading {

/// A sentence, where the assembly that a compiler made of an answer holds what no answer needs: instructions that the
/// file wrote itself, or directives by which an assembler reads other files.
std::vector<std::string> faults_of_assembly(const std::string& assembly);

}  // namespace raylab::grading
