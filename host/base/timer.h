// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace lobe {

// Seconds of a clock that never jumps.
class Stopwatch {
  public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
    // The seconds so far; counting begins anew.
    double restart() {
        const Clock::time_point now = Clock::now();
        const double passed = std::chrono::duration<double>(now - start_).count();
        start_ = now;
        return passed;
    }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace lobe
