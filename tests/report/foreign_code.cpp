// Suppresses reports of memory that Graphviz, Pango and Fontconfig allocate once and keep. The address sanitizer's leak
// check looks for this name.
extern "C" const char* __lsan_default_suppressions();

extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\nleak:libpango\nleak:libcairo\nleak:libglib\nleak:libgvc\nleak:libgvplugin\nleak:libcgraph\n";
}

// Pango calls Fontconfig in a thread of its own. Neither is compiled for the thread sanitizer, which therefore does not
// see how they wait for each other. That thread is started in a copy of a process that may have had several threads.
extern "C" const char* __tsan_default_options();

extern "C" const char* __tsan_default_options() { return "ignore_noninstrumented_modules=1:die_after_fork=0"; }
