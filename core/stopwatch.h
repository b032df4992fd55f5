#pragma once

#include <chrono>
#include <ctime>

namespace stipple {

/// Seconds since it was made: wall clock, and processor time of the whole process.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double cpuSeconds() const { return processorSeconds(CLOCK_PROCESS_CPUTIME_ID) - cpuStart_; }

  static double processorSeconds(clockid_t clock) {
    timespec t{};
    clock_gettime(clock, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  double cpuStart_ = processorSeconds(CLOCK_PROCESS_CPUTIME_ID);
};

/// Processor seconds of this thread between calls of lap().
class ThreadStopwatch {
 public:
  double lap() {
    const double last = last_;
    last_ = Stopwatch::processorSeconds(CLOCK_THREAD_CPUTIME_ID);
    return last_ - last;
  }

 private:
  double last_ = Stopwatch::processorSeconds(CLOCK_THREAD_CPUTIME_ID);
};

}  // namespace stipple
