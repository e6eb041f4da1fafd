// SPDX-License-Identifier: Apache-2.0
// A program run in a process of its own, so that what kills or stops it does not kill or stop us.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace lobe {

// How a child ended: by itself with a code, or by a signal.
struct ChildEnd {
    int code = -1;
    int signal = 0;
};

// A running child. It reads nothing, leaves no core, and ends when we do. What it writes on its
// standard output comes line by line; its standard error is kept, the first 64 KiB of it.
class Child {
  public:
    // `command` begins with the program's path. Throws Error (internal) if no process can be made.
    explicit Child(const std::vector<std::string>& command);
    // Kills what still runs.
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    enum class Read { line, end, late, interrupted };
    // Waits for the next line, without its end, for at most `seconds`; `interrupted` when a signal
    // came to us that asks to stop.
    Read read_line(std::string& line, double seconds);

    void kill() const;
    ChildEnd wait();
    const std::string& errors() const { return errors_; }

  private:
    bool take_line(std::string& line);
    void drain(int& file, std::string& text, std::size_t most);

    pid_t process_ = -1;
    int out_ = -1, err_ = -1;
    std::string output_, errors_;
};

}  // namespace lobe
