// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/usage.h"
#include "base/error.h"

namespace {

int report(const lobe::Error& error) {
    std::fprintf(stderr, "%s\n", error.message().c_str());
    return static_cast<int>(error.code());
}

int run(int argc, char** argv) {
    CLI::App app(
        "lobe renders pbrt scenes with OpenCL and tells how far each picture can be trusted.",
        "lobe");
    app.require_subcommand(1);
    const std::vector<std::string> command_line(argv, argv + argc);
    const std::vector<std::pair<std::string, lobe::Command>> commands = {
        {"render", lobe::add_render_command(app, command_line)},
        {"compare", lobe::add_compare_command(app, command_line)},
        {"bench", lobe::add_bench_command(app, command_line)},
        {"converge", lobe::add_converge_command(app, command_line)},
        {"features", lobe::add_features_command(app)},
        {"devices", lobe::add_devices_command(app)},
        {"brdf", lobe::add_brdf_command(app)},
        {"diff", lobe::add_diff_command(app)},
        {"paper", lobe::add_paper_command(app, command_line)},
    };
    app.set_version_flag("--version", "lobe " LOBE_VERSION);
    for (CLI::App* verb : app.get_subcommands({}))
        verb->set_version_flag("--version", "lobe " LOBE_VERSION);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::CallForVersion& version) {
        return app.exit(version);
    } catch (const CLI::ParseError& fault) {
        return report(lobe::usage_error(app, fault));
    }
    for (const auto& [name, command] : commands)
        if (app.got_subcommand(name)) return command();
    return static_cast<int>(lobe::ExitCode::usage);
}

int run_and_report(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const lobe::Error& error) {
        return report(error);
    } catch (const std::bad_alloc&) {
        return report({lobe::ExitCode::device, "the host's memory is used up"});
    } catch (const std::exception& error) {
        return report({lobe::ExitCode::internal, error.what(), "",
                       "this is a fault of lobe: please report it"});
    }
}

// A standard stream that is closed would give its number to the next file that is opened. Opened
// the wrong way round, it makes every use of it fail.
void fill_standard_streams() {
    for (int number : {0, 1, 2})
        if (fcntl(number, F_GETFD) < 0 && errno == EBADF)
            (void)!open("/dev/null", number == 0 ? O_WRONLY : O_RDONLY);
}

}  // namespace

int main(int argc, char** argv) {
    fill_standard_streams();
    std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of write, with a message
    const int code = run_and_report(argc, argv);
    const bool failed = std::ferror(stdout) != 0;
    if (std::fflush(stdout) == 0 && !failed) return code;
    const int told = report({lobe::ExitCode::output, "cannot write to standard output: " +
                                                         std::string(std::strerror(errno))});
    return code ? code : told;
}
