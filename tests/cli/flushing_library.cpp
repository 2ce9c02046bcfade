// Built with -O2 -ffast-math -shared, and preloaded: what one library of a host does to all its
// threads. gcc links crtfastmath.o into it; where the compiler does not, this sets the same bits.
#include <xmmintrin.h>

namespace {

__attribute__((constructor)) void flush_subnormals() {
  constexpr unsigned kFlushBoth = 0x8040;
  _mm_setcsr(_mm_getcsr() | kFlushBoth);
}

}  // namespace
