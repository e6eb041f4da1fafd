// SPDX-License-Identifier: Apache-2.0
// Runs a program as a shell would, without a shell: arguments and environment arrive as they are.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace lobe::test {

struct RunOptions {
    std::map<std::string, std::string> environment;  // added to ours; see `unset`
    std::vector<std::string> unset;                  // variables taken from it
    std::string folder;                              // working folder, ours if empty
    double timeout = 60;                             // seconds; then the process is killed
    std::optional<std::uint64_t> largest_file;       // bytes that a file may grow to
    bool terminal = false;                           // standard error is a terminal
    bool closed_stdout = false;                      // as >&- in a shell
    std::string stdout_file;                         // written there in place of RunResult::out
};

struct RunResult {
    int code = -1;   // exit code, or -1
    int signal = 0;  // that ended it, or 0
    bool timed_out = false;
    std::string out, err;
    double seconds = 0;
};

// A running program. Its destructor kills what still runs.
class Process {
  public:
    // `arguments` begins with the program's path. Throws std::runtime_error if it cannot start.
    Process(const std::vector<std::string>& arguments, const RunOptions& options = {});
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    // Collects what the program writes until standard error holds `text` so many times; false if it
    // ended or ran out of time before.
    bool wait_for_stderr(const std::string& text, unsigned times = 1);

    // Sends a signal.
    void kill(int signal) const;

    // Collects all output and the end.
    RunResult wait();

  private:
    bool read_some();
    double left() const;

    RunOptions options_;
    RunResult result_;
    pid_t process_ = -1;
    int out_ = -1, err_ = -1;
    double start_ = 0;
};

// Runs it to its end.
RunResult run(const std::vector<std::string>& arguments, const RunOptions& options = {});

}  // namespace lobe::test
