// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/man_page.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace isoscope::cli {

/// What the program hands to the shell.
enum ExitStatus { done = 0, inputHasErrors = 1, wrongUsage = 2 };

/// Arguments that do not go together, in a sentence; thrown by what runs a Command only.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// One option of a Command, of CLI11: its templates take seconds in each file that names them, so
/// command_line.cpp alone does. Each function returns the option itself.
class Option {
  public:
    explicit Option(CLI::Option* option) : option_(option) {}

    /// A command line without the option is wrong usage.
    Option& required(bool needed = true);
    /// Both ends are allowed.
    Option& within(int low, int high);
    Option& within(double low, double high);
    Option& positive();
    Option& oneOf(const std::vector<std::string>& words);
    Option& needs(const Option& other);
    Option& excludes(const Option& other);
    /// One value each time it is given.
    Option& oneValueEach();
    /// The present value of its target stands in the help.
    Option& showDefault();

  private:
    CLI::Option* option_;
};

/// A subcommand. Targets of options must live as long as the command line.
class Command {
  public:
    explicit Command(CLI::App* command) : command_(command) {}

    /// Adds an option, `names` as CLI11 has them ("-o,--out", or a bare word for a positional argument). The
    /// target keeps its value unless the option is given; a text that is not of its type is reported as wrong
    /// usage.
    Option option(const std::string& names, std::string& target, const std::string& description);
    Option option(const std::string& names, int& target, const std::string& description);
    Option option(const std::string& names, std::size_t& target, const std::string& description);
    Option option(const std::string& names, double& target, const std::string& description);
    Option option(const std::string& names, std::optional<double>& target, const std::string& description);
    Option option(const std::string& names, std::optional<int>& target, const std::string& description);
    Option option(const std::string& names, std::vector<std::string>& target, const std::string& description);
    Option flag(const std::string& names, bool& target, const std::string& description);
    /// The option that was added with this name.
    Option find(const std::string& name) const;
    /// What the command does; it may throw UsageError.
    void run(const std::function<ExitStatus()>& action);

  private:
    friend class CommandLine;
    CLI::App* command_;
    ExitStatus* status_ = nullptr;
};

/// The program's arguments: exactly one subcommand with its options.
class CommandLine {
  public:
    CommandLine(const std::string& description, const std::string& program, const std::string& version);
    ~CommandLine();

    /// Adds a subcommand; the description stands in the help.
    Command add(const std::string& name, const std::string& description);
    /// All of it as the manual page of the program, in man(7); `sections` stand behind the commands.
    std::string manual(const std::string& summary, std::vector<ManSection> sections) const;
    /// Reads the arguments and runs the command they name. Help, version and what is wrong with the arguments
    /// are printed.
    ExitStatus run(int argc, char** argv);

  private:
    std::unique_ptr<CLI::App> app_;
    std::string version_;
    ExitStatus status_ = done;
};

}  // namespace isoscope::cli
