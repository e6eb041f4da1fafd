// SPDX-License-Identifier: Apache-2.0
#include "support/process.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

extern char** environ;

namespace lobe::test {

namespace {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

std::vector<std::string> environment_of(const RunOptions& options) {
    std::map<std::string, std::string> variables;
    for (char** entry = environ; *entry; ++entry) {
        const std::string text = *entry;
        const std::size_t equals = text.find('=');
        variables[text.substr(0, equals)] = text.substr(equals + 1);
    }
    for (const std::string& name : options.unset) variables.erase(name);
    for (const auto& [name, value] : options.environment) variables[name] = value;
    std::vector<std::string> entries;
    for (const auto& [name, value] : variables) entries.push_back(name + "=" + value);
    return entries;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    for (std::string& text : texts) result.push_back(&text[0]);
    result.push_back(nullptr);
    return result;
}

struct Pipe {
    int read = -1, write = -1;
};

Pipe make_pipe(bool terminal) {
    Pipe ends;
    int pair[2];
    const int failed =
        terminal ? openpty(&ends.read, &ends.write, nullptr, nullptr, nullptr) : pipe(pair);
    if (failed) throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
    if (!terminal) ends = {pair[0], pair[1]};
    fcntl(ends.read, F_SETFD, FD_CLOEXEC);
    fcntl(ends.write, F_SETFD, FD_CLOEXEC);
    return ends;
}

// In the child, between fork and exec: calls that are safe there only.
[[noreturn]] void become(const RunOptions& options, int out, int err, char** arguments,
                         char** environment) {
    if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) _exit(126);
    dup2(err, STDERR_FILENO);
    if (options.closed_stdout)
        close(STDOUT_FILENO);
    else
        dup2(out, STDOUT_FILENO);
    if (options.largest_file) {
        const rlimit limit{*options.largest_file, *options.largest_file};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    execve(arguments[0], arguments, environment);
    _exit(127);
}

// Appends what can be read; false at the end.
bool drain(int& file, std::string& text) {
    char bytes[4096];
    const ssize_t count = read(file, bytes, sizeof bytes);
    if (count > 0) text.append(bytes, static_cast<std::size_t>(count));
    if (count > 0 || (count < 0 && errno == EINTR)) return true;
    close(file);  // the end; a terminal whose program is gone gives EIO
    file = -1;
    return false;
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const RunOptions& options)
    : options_(options), start_(now()) {
    std::vector<std::string> words = arguments, variables = environment_of(options);
    std::vector<char*> argv = pointers(words), envp = pointers(variables);
    const Pipe err = make_pipe(options.terminal);
    Pipe out;
    if (options.stdout_file.empty())
        out = make_pipe(false);
    else
        out.write =
            open(options.stdout_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    process_ = fork();
    if (process_ == 0) become(options, out.write, err.write, argv.data(), envp.data());
    close(out.write);
    close(err.write);
    out_ = out.read;
    err_ = err.read;
    if (process_ < 0) throw std::runtime_error("cannot start " + arguments[0]);
}

Process::~Process() {
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    for (int file : {out_, err_})
        if (file >= 0) close(file);
}

double Process::left() const { return start_ + options_.timeout - now(); }

// Waits for output; false when there is none any more, or no time.
bool Process::read_some() {
    pollfd files[2] = {{out_, POLLIN, 0}, {err_, POLLIN, 0}};
    if (out_ < 0 && err_ < 0) return false;
    if (left() <= 0) return false;
    const int ready = poll(files, 2, static_cast<int>(1000 * left()) + 1);
    if (ready <= 0) return ready < 0 && errno == EINTR;
    if (files[0].revents) drain(out_, result_.out);
    if (files[1].revents) drain(err_, result_.err);
    return true;
}

bool Process::wait_for_stderr(const std::string& text, unsigned times) {
    std::size_t at = 0;
    while (times > 0) {
        const std::size_t found = result_.err.find(text, at);
        if (found != std::string::npos) {
            at = found + text.size();
            --times;
        } else if (!read_some()) {
            return false;
        }
    }
    return true;
}

void Process::kill(int signal) const { ::kill(process_, signal); }

RunResult Process::wait() {
    while (read_some()) {
    }
    int status = 0;
    result_.timed_out = left() <= 0;
    if (result_.timed_out) ::kill(process_, SIGKILL);
    waitpid(process_, &status, 0);
    process_ = -1;
    if (WIFEXITED(status)) result_.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) result_.signal = WTERMSIG(status);
    result_.seconds = now() - start_;
    return result_;
}

RunResult run(const std::vector<std::string>& arguments, const RunOptions& options) {
    return Process(arguments, options).wait();
}

}  // namespace lobe::test
