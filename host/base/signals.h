// SPDX-License-Identifier: Apache-2.0
// SIGINT and SIGTERM: the first asks the work to stop at the next good place, the second ends the
// process at once.
#pragma once

namespace lobe {

void install_signal_handlers();

// The signal that asked to stop, or 0. To be asked between launches.
int stop_signal();

// What the process returns after stopping for stop_signal(): 130 for SIGINT, 143 for SIGTERM.
int stop_exit_code();

}  // namespace lobe
