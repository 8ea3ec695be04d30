// Suppresses reports of memory that Graphviz, Pango and Fontconfig allocate once and keep. The address sanitizer's leak
// check looks for this name.
extern "C" const char* __lsan_default_suppressions();

extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\nleak:libpango\nleak:libcairo\nleak:libglib\nleak:libgvc\nleak:libgvplugin\nleak:libcgraph\n";
}
