// Fontconfig keeps its patterns (a kilobyte, however many pictures are drawn) until the process ends.
#ifdef KNOTFIT_SANITIZED
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libfontconfig\n";
}
#endif
