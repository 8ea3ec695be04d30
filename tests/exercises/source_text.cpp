#include "catch.h"

#include "source_text.h"

#include <string>

// What the preprocessor takes for a directive is found, and nothing else is.

using raylab::grading::faults_of_directives;

namespace {

const std::string forbidden = "#include \"/etc/passwd\"\n";

}  // namespace

TEST_CASE("a comment as long as a file may be hides no directive behind it") {
    std::string text = "/*\n";
    while (text.size() < (1 << 20) - 100) text += " * x\n";
    CHECK(faults_of_directives(text + "*/\n").empty());
    CHECK(faults_of_directives(text + "*/\n" + forbidden).size() == 1);
}

TEST_CASE("what a comment says is no directive") {
    CHECK(faults_of_directives("/*\n" + forbidden + "*/\n").empty());
    CHECK(faults_of_directives("int a = 1'000; /* one\n" + forbidden + "*/\n").empty());
}

TEST_CASE("what a literal or a comment of one line says hides no directive") {
    for (const std::string& before :
         {R"(const char* s = "/*";)", R"(const char* s = "\"/*";)", R"(const char c = '"'; /* " */)",
          R"x(const char* s = R"(/*)";)x", R"x(const char* s = u8R"(\)";)x", "// /*", "int a = 1'000;  // '",
          "#error don't /* do */ this", "const char* s = UR\"(\n/*)\";", "int R = 0; const char* s = aR\"(/*\";",
          "const char* s = R\"(\\\n)\";"}) {
        INFO(before);
        CHECK(faults_of_directives(before + "\n" + forbidden + "// */\n").size() == 1);
    }
}

TEST_CASE("a directive is one however it is broken up, and however long its line is") {
    for (const std::string& text :
         {std::string("  # /* a\n */ include/**/\"/etc/passwd\" // b\n"), std::string("#inc\\\nlude \"/etc/passwd\"\n"),
          std::string("#inc\\ \t\nlude \"/etc/passwd\"\n"), std::string("%:include_next \"/etc/passwd\""),
          "#include" + std::string(300, ' ') + "\"/etc/passwd\"\n"}) {
        INFO(text);
        CHECK(faults_of_directives(text).size() == 1);
    }
    CHECK(faults_of_directives("#include <cmath>\n#include \"raylab/geometry/ray.h\"  // /* a */\n").empty());
}
