#include "options_page.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "config_file.h"

namespace beadmesh::app {
namespace {

/// In a cell of a table: one line, bars and angle brackets as text.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '[' || c == ']') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

std::string option_row(const CLI::Option& option) {
  const bool is_flag = option.get_items_expected_max() == 0;
  const std::string name = option.get_positional() ? option.get_name(true) : option.get_name(false, true);
  return fmt::format("| `{}`{} | {}{} |\n", name, is_flag ? "" : " " + cell(option.get_type_name()),
                     cell(option.get_description()), option.get_required() ? "; required" : "");
}

std::string verb_section(const CLI::App& verb) {
  std::string text = fmt::format("\n## beadmesh {}\n\n{}.\n\n| option | meaning |\n|---|---|\n",
                                 verb.get_name(), verb.get_description());
  for (const CLI::Option* option : verb.get_options()) text += option_row(*option);
  return text;
}

std::string settings_section() {
  std::string text =
      "\n## Keys of the configuration file\n\n[settings](settings.md) has them with their defaults and "
      "meaning.\n\n"
      "| table | key | value |\n|---|---|---|\n";
  for (const ConfigKey& key : config_keys())
    text += fmt::format("| {} | `{}` | {} |\n", key.table.empty() ? "" : "`" + key.table + "`", key.name,
                        cell(key.type));
  return text;
}

}  // namespace

std::string page_of(const CLI::App& app) {
  std::string text =
      "# Options\n\nMade by `beadmesh options > docs/options.md` from the program's own options; not to be "
      "edited.\n";
  for (const CLI::App* verb : app.get_subcommands({}))
    if (!verb->get_group().empty()) text += verb_section(*verb);
  return text + settings_section();
}

}  // namespace beadmesh::app
