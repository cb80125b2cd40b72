// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"

#include <CLI/CLI.hpp>

namespace isoscope::cli {

Option& Option::required(bool needed) {
    option_->required(needed);
    return *this;
}

Option& Option::within(int low, int high) {
    option_->check(CLI::Range(low, high));
    return *this;
}

Option& Option::within(double low, double high) {
    option_->check(CLI::Range(low, high));
    return *this;
}

Option& Option::positive() {
    option_->check(CLI::PositiveNumber);
    return *this;
}

Option& Option::oneOf(const std::vector<std::string>& words) {
    option_->check(CLI::IsMember(words));
    return *this;
}

Option& Option::needs(const Option& other) {
    option_->needs(other.option_);
    return *this;
}

Option& Option::excludes(const Option& other) {
    option_->excludes(other.option_);
    return *this;
}

Option& Option::oneValueEach() {
    option_->allow_extra_args(false);
    return *this;
}

Option& Option::showDefault() {
    option_->capture_default_str();
    return *this;
}

Option Command::option(const std::string& names, std::string& target, const std::string& description) {
    return Option(command_->add_option(names, target, description));
}

Option Command::option(const std::string& names, int& target, const std::string& description) {
    return Option(command_->add_option(names, target, description));
}

Option Command::option(const std::string& names, std::size_t& target, const std::string& description) {
    return Option(command_->add_option(names, target, description));
}

Option Command::option(const std::string& names, double& target, const std::string& description) {
    return Option(command_->add_option(names, target, description));
}

Option Command::option(const std::string& names, std::optional<double>& target,
                       const std::string& description) {
    return Option(command_->add_option(names, target, description));
}

Option Command::option(const std::string& names, std::optional<int>& target, const std::string& description) {
    return Option(command_->add_option(names, target, description));
}

Option Command::option(const std::string& names, std::vector<std::string>& target,
                       const std::string& description) {
    return Option(command_->add_option(names, target, description));
}

Option Command::flag(const std::string& names, bool& target, const std::string& description) {
    return Option(command_->add_flag(names, target, description));
}

Option Command::find(const std::string& name) const { return Option(command_->get_option(name)); }

void Command::run(const std::function<ExitStatus()>& action) {
    command_->callback([action, status = status_] {
        try {
            *status = action();
        } catch (const UsageError& error) {
            throw CLI::ValidationError(error.what());
        }
    });
}

CommandLine::CommandLine(const std::string& description, const std::string& program,
                         const std::string& version)
    : app_(std::make_unique<CLI::App>(description, program)), version_(version) {
    app_->set_version_flag("--version", version);
    app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

Command CommandLine::add(const std::string& name, const std::string& description) {
    Command command(app_->add_subcommand(name, description));
    command.status_ = &status_;
    return command;
}

namespace {

/// "-W,--width INT", with what is taken where nothing is given behind the description.
ManEntry entryOf(const CLI::Option& option) {
    std::string term = option.get_positional() ? option.get_name(true) : option.get_name(false, true);
    if (const std::string type = option.get_type_name(); !option.get_positional() && !type.empty())
        term += ' ' + type;
    std::string text = option.get_description();
    if (const std::string usual = option.get_default_str(); !usual.empty()) text += " [" + usual + ']';
    if (option.get_required() && !option.get_positional()) text += " (required)";
    return {term, text};
}

}  // namespace

std::string CommandLine::manual(const std::string& summary, std::vector<ManSection> sections) const {
    ManPage page{app_->get_name(), version_, summary, "COMMAND [OPTIONS]", {}};
    page.sections.push_back({"DESCRIPTION", app_->get_description(), {}});
    page.sections.push_back({"COMMANDS", "", {}});
    for (const CLI::App* command : app_->get_subcommands([](const CLI::App*) { return true; })) {
        ManSection section{command->get_name(), command->get_description() + '.', {}};
        for (const CLI::Option* option : command->get_options()) section.entries.push_back(entryOf(*option));
        page.sections.push_back(std::move(section));
    }
    for (ManSection& section : sections) page.sections.push_back(std::move(section));
    return toRoff(page);
}

ExitStatus CommandLine::run(int argc, char** argv) {
    try {
        app_->parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app_->exit(error) == 0 ? done : wrongUsage;
    }
    return status_;
}

}  // namespace isoscope::cli
