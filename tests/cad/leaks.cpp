// OpenCASCADE keeps what its readers set up (3 kB, however many files are read) until the process ends.
#ifdef KNOTFIT_SANITIZED
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libTK\n";
}
#endif
