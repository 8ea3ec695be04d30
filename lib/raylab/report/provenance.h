#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace raylab {

/// A name and a value, as the lab book shows them.
struct Fact {
    std::string name, value;
};

/// Whose numbers these are: processor, cores, system, compiler, version and commit, date.
std::vector<Fact> machine_facts();

/// The processor as it names itself.
std::string processor_name();

/// Where raylab's sources stand, and where this build does.
std::filesystem::path source_folder();
std::filesystem::path build_folder();

}  // namespace raylab
