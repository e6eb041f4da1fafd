// SPDX-License-Identifier: Apache-2.0
// Ends a render whose launch never comes back: a kernel that runs cannot be cancelled, so all that
// is left is to save what is complete and to end the process.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "base/timer.h"

namespace lobe {

class Watchdog {
  public:
    // A launch may take `seconds` and, beyond that, a hundred times what the largest launches so
    // far lead to expect; before the first, the pace of a simulator is supposed. So a slow device
    // is never taken for one that hangs. `on_hang` is then called with the limit, in a thread of
    // its own, and the thread that renders is held where its launch ends, so that nothing changes
    // meanwhile. If it returns, the render goes on. 0 seconds: no watch.
    Watchdog(double seconds, std::function<void(double)> on_hang);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    // A launch of so much work, in samples, from its beginning to its end. `dog` may be null.
    class Launch {
      public:
        Launch(Watchdog* dog, double work) : dog_(dog) {
            if (dog_) dog_->begin(work);
        }
        ~Launch() {
            if (dog_) dog_->end();
        }
        Launch(const Launch&) = delete;
        Launch& operator=(const Launch&) = delete;

      private:
        Watchdog* dog_;
    };

    // Seconds that a launch of so much work may take as things stand.
    double limit(double work) const;

  private:
    void begin(double work);
    void end();
    void learn(double work, double seconds);
    void watch();

    const double seconds_;
    const std::function<void(double)> on_hang_;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool running_ = false, fired_ = false, over_ = false;
    Stopwatch launch_;
    double work_ = 0, limit_ = 0, waited_ = 0;   // of the launch that runs
    double known_work_ = 0, known_seconds_ = 0;  // of the slowest among the largest so far
    std::thread thread_;
};

}  // namespace lobe
