// SPDX-License-Identifier: Apache-2.0
#include "base/signals.h"

#include <unistd.h>

#include <csignal>

namespace lobe {

namespace {

volatile std::sig_atomic_t stopped_by = 0;

void on_signal(int signal) {
    if (stopped_by) _exit(128 + signal);
    stopped_by = signal;
}

}  // namespace

void install_signal_handlers() {
    struct sigaction action = {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

int stop_signal() { return stopped_by; }
int stop_exit_code() { return 128 + stopped_by; }

}  // namespace lobe
