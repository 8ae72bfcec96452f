// SPDX-License-Identifier: BSD-3-Clause
#include "shared/CommandDescription.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string_view>
#include <vector>

namespace palpate::app {

namespace {

/// Returns the text on one line without tabs.
std::string oneField(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
    return text;
}

std::string namesOf(const CLI::Option& option)
{
    if (option.get_positional()) {
        return option.get_single_name();
    }
    std::string names;
    const auto add = [&names](std::string_view dashes, const std::vector<std::string>& all) {
        for (const std::string& name : all) {
            names.append(names.empty() ? "" : ",").append(dashes).append(name);
        }
    };
    add("-", option.get_snames());
    add("--", option.get_lnames());
    return names;
}

void describeOne(const CLI::App& app, const std::string& path, std::string& text)
{
    text += "command\t" + path + '\t' + oneField(app.get_description()) + '\n';
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_group().empty()) {
            continue;
        }
        const bool hasValue = option->get_items_expected_max() > 0;
        const bool hasSeveral = option->get_items_expected_max() > 1;
        const char* flags =
            option->get_required() ? (hasSeveral ? "required,several" : "required") : (hasSeveral ? "several" : "");
        text += "option\t" + path + '\t' + namesOf(*option) + '\t' +
                (hasValue ? oneField(option->get_type_name()) : std::string()) + '\t' + flags + '\t' +
                oneField(option->get_default_str()) + '\t' + oneField(option->get_description()) + '\n';
    }
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        describeOne(*command, path.empty() ? command->get_name() : path + ' ' + command->get_name(), text);
    }
}

} // namespace

std::string describeCommands(const CLI::App& app)
{
    std::string text;
    describeOne(app, {}, text);
    return text;
}

} // namespace palpate::app
