/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/OptionChecks.h"

#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace tissue
{
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
EndsIn(const std::string & extension)
{
  const auto check = [extension](const std::string & path) {
    const bool ends = std::filesystem::path(path).extension() == extension;
    return ends ? std::string() : "the name of the file, '" + path + "', must end in " + extension;
  };
  return CLI::Validator(check, "*" + extension);
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
    app.parse(argc, argv);
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
