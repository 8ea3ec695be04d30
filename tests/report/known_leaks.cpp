// What Graphviz, Pango and Fontconfig allocate once and keep is not ours to free. The address sanitizer's leak check
// asks for this name.
extern "C" const char* __lsan_default_suppressions();

extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\nleak:libpango\nleak:libcairo\nleak:libglib\nleak:libgvc\nleak:libgvplugin\nleak:libcgraph\n";
}
