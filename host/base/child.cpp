// SPDX-License-Identifier: Apache-2.0
#include "base/child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "base/error.h"
#include "base/signals.h"
#include "base/timer.h"

namespace lobe {

namespace {

constexpr std::size_t most_errors = 1 << 16;
constexpr std::size_t most_output = 1 << 20;

struct Pipe {
    int ends[2] = {-1, -1};
    Pipe() {
        if (pipe2(ends, O_CLOEXEC) != 0)
            throw Error(ExitCode::internal, std::string("no pipe: ") + std::strerror(errno));
    }
};

// In the child, between fork and exec: only calls that are safe there.
[[noreturn]] void become(char* const* arguments, int out, int err, pid_t parent) {
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(127);  // we were orphaned before we asked
    execv(arguments[0], arguments);
    _exit(127);
}

}  // namespace

Child::Child(const std::vector<std::string>& command) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    Pipe out, err;
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ == 0) become(arguments.data(), out.ends[1], err.ends[1], parent);
    const int reason = errno;
    close(out.ends[1]);
    close(err.ends[1]);
    out_ = out.ends[0];
    err_ = err.ends[0];
    if (process_ > 0) return;
    close(out_);
    close(err_);
    throw Error(ExitCode::internal, std::string("no new process: ") + std::strerror(reason));
}

Child::~Child() {
    if (process_ > 0) {
        kill();
        wait();
    }
    for (const int file : {out_, err_})
        if (file >= 0) close(file);
}

void Child::kill() const {
    if (process_ > 0) ::kill(process_, SIGKILL);
}

ChildEnd Child::wait() {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    ChildEnd end;
    if (WIFEXITED(status)) end.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
    return end;
}

bool Child::take_line(std::string& line) {
    const std::size_t end = output_.find('\n');
    if (end == std::string::npos) return false;
    line = output_.substr(0, end);
    output_.erase(0, end + 1);
    return true;
}

// Takes what there is; what would be too much is read and dropped, so that the child can go on.
void Child::drain(int& file, std::string& text, std::size_t most) {
    char bytes[4096];
    const ssize_t count = read(file, bytes, sizeof bytes);
    if (count < 0 && errno == EINTR) return;
    if (count <= 0) {
        close(file);
        file = -1;
        return;
    }
    const std::size_t room = most - std::min(most, text.size());
    text.append(bytes, std::min(static_cast<std::size_t>(count), room));
}

Child::Read Child::read_line(std::string& line, double seconds) {
    const Stopwatch watch;
    while (!take_line(line)) {
        if (stop_signal()) return Read::interrupted;
        if (out_ < 0) return Read::end;
        const double left = seconds - watch.seconds();
        if (left <= 0) return Read::late;
        // A file of -1 is left out. No longer than a second, for a signal may come just before.
        pollfd files[2] = {{out_, POLLIN, 0}, {err_, POLLIN, 0}};
        poll(files, 2, static_cast<int>(1000 * std::min(left, 1.0)) + 1);
        if (files[0].revents) drain(out_, output_, most_output);
        if (files[1].revents) drain(err_, errors_, most_errors);
    }
    return Read::line;
}

}  // namespace lobe
