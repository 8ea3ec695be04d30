#pragma once

#include <string>
#include <vector>

namespace raylab {

/// Throws an Error that says today's name where a word of a command line is the former name of an option or a
/// structure. A structure is looked for behind the options that take one, alone, in a list and with its setting:
/// "wide", "kd,wide", "grid:10".
void refuse_retired_names(const std::vector<std::string>& words);

/// The same for structures alone, as files name them; several are separated by commas.
void refuse_retired_structures(const std::string& list);

}  // namespace raylab
