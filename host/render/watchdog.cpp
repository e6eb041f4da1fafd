// SPDX-License-Identifier: Apache-2.0
#include "render/watchdog.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace lobe {
namespace {

constexpr double simulator_pace = 0.02;  // seconds a sample of paths that may be slow and still run
constexpr double patience = 100;         // rows of a picture differ: sky here, many bounces there
constexpr double tick = 0.25;            // seconds

}  // namespace

double Watchdog::limit(double work) const {
    if (known_work_ <= 0) return seconds_ + simulator_pace * work;
    return seconds_ + patience * known_seconds_ * std::max(1.0, work / known_work_);
}

// Small launches tell nothing of large ones on a device that does thousands of samples at a time.
void Watchdog::learn(double work, double seconds) {
    if (work > 2 * known_work_) {
        known_work_ = work;
        known_seconds_ = seconds;
    } else if (2 * work > known_work_) {
        known_seconds_ = std::max(known_seconds_, seconds);
    }
}

Watchdog::Watchdog(double seconds, std::function<void(double)> on_hang)
    : seconds_(seconds), on_hang_(std::move(on_hang)) {
    if (seconds_ > 0) thread_ = std::thread([this] { watch(); });
}

Watchdog::~Watchdog() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        over_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void Watchdog::begin(double work) {
    const std::lock_guard<std::mutex> lock(mutex_);
    running_ = true;
    work_ = work;
    waited_ = 0;
    limit_ = limit(work);
    launch_.restart();
}

void Watchdog::end() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (fired_) changed_.wait(lock);  // the picture is being written: too late to go on
    running_ = false;
    learn(work_, std::min(launch_.seconds(), waited_ + 2 * tick));
}

// Time is counted in ticks: while the process is stopped or the machine sleeps, none passes.
void Watchdog::watch() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (!over_) {
        const Stopwatch since;
        changed_.wait_for(lock, std::chrono::duration<double>(tick));
        if (over_ || !running_) continue;
        waited_ += std::min(since.seconds(), 2 * tick);
        if (waited_ <= limit_) continue;
        fired_ = true;
        lock.unlock();
        on_hang_(limit_);
        lock.lock();
        fired_ = false;
        waited_ = 0;
        changed_.notify_all();
    }
}

}  // namespace lobe
