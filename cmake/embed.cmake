# cmake -D FILES=<file>;... -D FUNCTION=<name> -D SOURCE=<file> -P embed.cmake: writes SOURCE, a function of raylab that returns the
# files' text, one after the other.
set(text "")
foreach(file IN LISTS FILES)
  file(READ "${file}" content)
  string(APPEND text "${content}")
endforeach()
file(WRITE "${SOURCE}" "// Made by cmake/embed.cmake.\n#include \"raylab/report/page/embedded.h\"\n\nnamespace raylab {\nconst char* ${FUNCTION}() {\n    return R\"embedded(${text})embedded\";\n}\n}  // namespace raylab\n")
