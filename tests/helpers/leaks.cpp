// SPDX-License-Identifier: Apache-2.0
// Suppressions for the leak sanitizer: memory that libraries keep until the process ends. Linked
// into every program that uses one of them: `jaywalk`, `jaywalk-draw`, the unit tests of tools.

#ifdef __SANITIZE_ADDRESS__
// - libfontconfig, beneath cairo (tools/picture), keeps what it has read of the fonts.
// - libedit (tools/jaywalk/repl/line_editor.cpp) does not give back two texts that it copies by
// wcsdup.
// The sanitizer's library calls it, so that it must be visible there.
// NOLINTNEXTLINE(bugprone-reserved-identifier): the name is the sanitizer's.
extern "C" [[gnu::visibility("default")]] const char* __lsan_default_suppressions() {
  return "leak:libfontconfig\nleak:wcsdup";
}
#endif
