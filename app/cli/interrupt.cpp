#include "app/cli/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace stipple {

namespace {

// The one thing that a signal handler may touch.
volatile std::sig_atomic_t interrupted = 0;

void markInterrupted(int) {
  interrupted = 1;
}

}  // namespace

void catchInterrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, markInterrupted);
}

bool wasInterrupted() {
  return interrupted != 0;
}

}  // namespace stipple
