// SPDX-License-Identifier: Apache-2.0
#include "lab/trial/trial.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "base/child.h"
#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "base/sha256.h"
#include "cl/binary_cache.h"
#include "cl/device.h"
#include "cl/program.h"
#include "lab/brdf_probe.h"
#include "lab/trial/trial_run.h"

namespace lobe {
namespace {

constexpr std::size_t most_passes = 256;  // that are remembered
constexpr rlim_t most_memory = rlim_t{8} << 30;

// Changes with the trial itself: an older pass may not have tried as much.
const char* const trial_number = "trial 1";

// All that a pass depends on: the texts, the device and how they are built, lobe.
std::string key_of(const Device& device, const KernelText& kernels, const BrdfTable& model,
                   const std::string& version) {
    return sha256(program_key(device.info(), brdf_probe_source(kernels, model)) + "\n" +
                  trial_number + "\n" + version);
}

std::string memory_file() { return cache_folder() + "/trials"; }

std::vector<std::string> passes() {
    std::vector<std::string> keys;
    std::ifstream file(cache_folder().empty() ? "" : memory_file());
    for (std::string key; std::getline(file, key);) keys.push_back(key);
    return keys;
}

bool has_passed(const std::string& key) {
    const std::vector<std::string> keys = passes();
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

// A memory that cannot be written is only another trial next time.
void remember_pass(const std::string& key) {
    if (cache_folder().empty()) return;
    std::vector<std::string> keys = passes();
    keys.push_back(key);
    std::string text;
    for (std::size_t i = keys.size() - std::min(keys.size(), most_passes); i < keys.size(); ++i)
        text += keys[i] + "\n";
    try {
        std::filesystem::create_directories(cache_folder());
        write_file(memory_file(), text);
    } catch (const std::exception&) {
    }
}

// Where the child tells "step WHAT"; "passed KEY", or "fault CODE" and a line each for where, what
// and hint. What was its standard output: what kernels print goes to standard error from now on.
class Teller {
  public:
    Teller() : file_(fdopen(dup(STDOUT_FILENO), "w")) {
        dup2(STDERR_FILENO, STDOUT_FILENO);
        if (!file_) throw Error(ExitCode::internal, "no standard output");
    }
    void say(const std::string& line) {
        std::fprintf(file_, "%s\n", line.c_str());
        std::fflush(file_);
    }

  private:
    std::FILE* file_;
};

Error told_fault(Child& child, const std::string& code, const BrdfTable& model) {
    std::string where, what, hint;
    for (std::string* line : {&where, &what, &hint}) child.read_line(*line, 10);
    return Error(static_cast<ExitCode>(std::atoi(code.c_str())), what,
                 where.empty() ? model.file : where, hint);
}

Error untimely_end(const ChildEnd& end, const std::string& step, const std::string& errors,
                   const BrdfTable& model) {
    const std::string how = end.signal ? std::string("crashed (") + strsignal(end.signal) + ")"
                                       : "ended the process with code " + std::to_string(end.code);
    const std::string word = errors.substr(0, errors.find('\n'));
    return Error(ExitCode::device, step + " " + how + " when it was tried", model.file,
                 word.empty() ? "look at its pointers and array indices, for directions and "
                                "parameters of any size and for NaN"
                              : "the driver's last words: " + word);
}

Error late_end(const std::string& step, double seconds, const BrdfTable& model) {
    char text[32];
    std::snprintf(text, sizeof text, "%g s", seconds);
    return Error(ExitCode::device, step + " did not end within " + text + " when it was tried",
                 model.file,
                 "look at its loops, for directions and parameters of any size and for NaN; on a "
                 "slow device set LOBE_TRIAL_SECONDS");
}

// What a compiler or a kernel may take of the host's memory, beyond what the driver has mapped.
void limit_memory() {
    std::ifstream file("/proc/self/statm");
    rlim_t pages = 0;
    file >> pages;
    const rlim_t most = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + most_memory;
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    limit.rlim_cur = std::min({most, limit.rlim_cur, limit.rlim_max});
    setrlimit(RLIMIT_AS, &limit);
}

}  // namespace

bool try_model(const Device& device, const KernelText& kernels, const BrdfTable& model,
               const TrialOptions& options) {
    const std::string key = key_of(device, kernels, model, options.version);
    if (has_passed(key)) return true;
    note("trying " + model.file + " in a process of its own first");
    std::vector<std::string> command{options.program, "brdf", "trial", "--device",
                                     std::to_string(device.info().number)};
    if (!options.kernel_folder.empty())
        command.insert(command.end(), {"--kernel-dir", options.kernel_folder});
    command.insert(command.end(), {"--", model.file});
    Child child(command);
    std::string line, step = "its start";
    for (;;) {
        const Child::Read read = child.read_line(line, options.seconds);
        if (read == Child::Read::interrupted) return false;
        if (read == Child::Read::late) throw late_end(step, options.seconds, model);
        if (read == Child::Read::end) throw untimely_end(child.wait(), step, child.errors(), model);
        const std::size_t blank = std::min(line.find(' '), line.size());
        const std::string word = line.substr(0, blank), rest = line.substr(blank).erase(0, 1);
        if (word == "step") step = rest;
        if (word == "fault") throw told_fault(child, rest, model);
        if (word != "passed") continue;
        if (rest != key)
            throw Error(ExitCode::scene, "the file changed while it was tried", model.file);
        remember_pass(key);
        return true;
    }
}

int serve_trial(const Device& device, const KernelText& kernels, const BrdfTable& model,
                const std::string& version) {
    if (device.info().type & CL_DEVICE_TYPE_CPU) limit_memory();
    Teller teller;
    try {
        const std::string key = key_of(device, kernels, model, version);
        run_trial(device, kernels, model,
                  [&](const std::string& step) { teller.say("step " + step); });
        teller.say("passed " + key);
        return 0;
    } catch (const Error& error) {
        teller.say("fault " + std::to_string(static_cast<int>(error.code())) + "\n" +
                   printable(error.where()) + "\n" + error.what() + "\n" + printable(error.hint()));
        return static_cast<int>(error.code());
    }
}

double trial_seconds() {
    const char* value = std::getenv("LOBE_TRIAL_SECONDS");
    const double seconds = value ? std::atof(value) : 0;
    return seconds > 0 ? seconds : TrialOptions().seconds;
}

}  // namespace lobe
