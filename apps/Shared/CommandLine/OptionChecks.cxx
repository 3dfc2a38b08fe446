/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/OptionChecks.h"

#include "Shared/CommandLine/OptionType.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
/** Whether the argument is a flag that may have a number. */
bool
MayHaveNumber(const CLI::App & app, const std::string & argument)
{
  const CLI::Option * const option = app.get_option_no_throw(argument);
  return option != nullptr && option->get_expected_max() == 0 && OptionType(*option).least;
}

/** The arguments in the order that CLI11 takes them, the last first. */
std::vector<std::string>
ListArguments(const CLI::App & app, int argc, char ** argv)
{
  std::vector<std::string> arguments;
  for (int i = 1; i < argc; ++i)
  {
    if (i > 1 && FindNumber(argv[i]) && MayHaveNumber(app, argv[i - 1]))
    {
      arguments.back() += std::string("=") + argv[i];
    }
    else
    {
      arguments.emplace_back(argv[i]);
    }
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}
} // namespace

CLI::Validator
InRange(double least, double most)
{
  std::ostringstream range;
  range << least << " .. " << most;
  const auto check = [least, most, text = range.str()](const std::string & argument) {
    double     value = 0.0;
    const bool isIn = CLI::detail::lexical_cast(argument, value) && value >= least && value <= most;
    return isIn ? std::string() : argument + " is out of range, must be in " + text;
  };
  return CLI::Validator(check, range.str());
}

CLI::Validator
EndsIn(const std::vector<std::string> & extensions)
{
  std::string list;
  std::string patterns;
  for (const std::string & extension : extensions)
  {
    list += (list.empty() ? "" : " or ") + extension;
    patterns += (patterns.empty() ? "*" : " or *") + extension;
  }
  const auto check = [extensions, list](const std::string & path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    const bool        ends = std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
    return ends ? std::string() : "the name of the file, '" + path + "', must end in " + list;
  };
  return CLI::Validator(check, patterns);
}

CLI::Validator
EndsIn(const std::string & extension)
{
  return EndsIn(std::vector<std::string>{ extension });
}

FoundOptions
FindOptions(const std::vector<std::string> & names, int argc, char ** argv)
{
  CLI::App app;
  app.allow_extras();
  app.set_help_flag();
  FoundOptions found;
  for (const std::string & name : names)
  {
    app.add_option(name, found[name]);
  }
  app.parse(argc, argv);
  for (const std::string & name : names)
  {
    if (app.count(name) == 0)
    {
      found.erase(name);
    }
  }
  return found;
}

bool
Parse(CLI::App & app, int argc, char ** argv)
{
  try
  {
    app.parse(ListArguments(app, argc, argv));
  }
  catch (const CLI::Success & success)
  {
    app.exit(success);
    return false;
  }
  catch (const CLI::Error & error)
  {
    throw std::runtime_error(std::string(error.what()) + " (--help lists the options)");
  }
  return true;
}
} // namespace tissue
