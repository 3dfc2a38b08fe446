/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/OptionType.h"

#include <sstream>

namespace tissue
{
namespace
{
bool
BeginsWith(const std::string & text, const std::string & beginning)
{
  return text.rfind(beginning, 0) == 0;
}

} // namespace

std::optional<double>
FindNumber(const std::string & text)
{
  double value = 0.0;
  return CLI::detail::lexical_cast(text, value) ? std::optional<double>(value) : std::nullopt;
}

OptionType::OptionType(const CLI::Option & option)
{
  std::istringstream parts(option.get_type_name());
  std::getline(parts, type, ':');
  for (std::string check; std::getline(parts, check, ':');)
  {
    this->AddCheck(check);
  }
  // Several of one type are "[FLOAT,FLOAT]" to CLI11.
  const std::string each = type.substr(BeginsWith(type, "[") ? 1 : 0);
  isReal = BeginsWith(each, "FLOAT");
  isInteger = BeginsWith(each, "INT") || BeginsWith(each, "UINT") || BeginsWith(each, "NUMBER");
}

bool
OptionType::Contains(double value) const
{
  return (!least || value >= *least) && (!most || value <= *most);
}

void
OptionType::AddCheck(const std::string & check)
{
  const auto dots = check.find(" .. ");
  if (BeginsWith(check, "{"))
  {
    std::istringstream values(check.substr(1, check.size() - 2));
    choices.clear();
    for (std::string value; std::getline(values, value, ',');)
    {
      choices.push_back(value);
    }
  }
  else if (BeginsWith(check, "*."))
  {
    extension = check.substr(1, check.find(' ') - 1);
  }
  else if (dots != std::string::npos)
  {
    least = FindNumber(check.substr(0, dots));
    most = FindNumber(check.substr(dots + 4));
  }
}
} // namespace tissue
