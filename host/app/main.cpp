// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "app/command.h"
#include "base/error.h"

namespace {

int report(const lobe::Error& error) {
    std::fprintf(stderr, "%s\n", error.message().c_str());
    return static_cast<int>(error.code());
}

int run(int argc, char** argv) {
    CLI::App app("lobe renders pbrt scenes with OpenCL and tells how far each picture can be trusted.");
    app.set_version_flag("--version", "lobe " LOBE_VERSION);
    app.require_subcommand(1);
    app.failure_message(CLI::FailureMessage::simple);
    const std::vector<std::string> command_line(argv, argv + argc);
    const std::vector<std::pair<std::string, lobe::Command>> commands = {
        {"render", lobe::add_render_command(app, command_line)},
        {"features", lobe::add_features_command(app)},
        {"devices", lobe::add_devices_command(app)},
    };
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::CallForVersion& version) {
        return app.exit(version);
    } catch (const CLI::ParseError& error) {
        const lobe::Error usage(lobe::ExitCode::usage, error.what(), "", "see `lobe --help` or `lobe render --help`");
        return report(usage);
    }
    for (const auto& [name, command] : commands)
        if (app.got_subcommand(name)) return command();
    return static_cast<int>(lobe::ExitCode::usage);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const lobe::Error& error) {
        return report(error);
    } catch (const std::bad_alloc&) {
        return report({lobe::ExitCode::device, "the host's memory is used up"});
    } catch (const std::exception& error) {
        return report({lobe::ExitCode::internal, error.what(), "", "this is a fault of lobe: please report it"});
    }
}
