#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace raylab {

/// A named value, as the lab book shows it.
struct Fact {
    std::string name, value;
};

/// The origin of a run's numbers: processor, cores, system, compiler, version and commit, date.
std::vector<Fact> machine_facts();

/// The processor's own name.
std::string processor_name();

/// The folders of raylab's sources and of this build. A handout (raylab handout) is laid out as they are and may stand
/// anywhere: its program finds it by its own place.
std::filesystem::path source_folder();
std::filesystem::path build_folder();

}  // namespace raylab
