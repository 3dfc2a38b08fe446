/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/ReturnParameters.h"

#include <charconv>
#include <fstream>
#include <stdexcept>

namespace tissue
{
void
WriteReturnParameters(const ReturnParameters & parameters, const std::string & path)
{
  std::ofstream file(path, std::ios::binary);
  for (const auto & [name, value] : parameters)
  {
    char       text[400];
    const auto end = std::to_chars(text, text + sizeof(text), value, std::chars_format::fixed, 6).ptr;
    const auto digits = std::string(text, end).find_last_not_of('0') + 1;
    file << name << " = " << std::string(text, text[digits - 1] == '.' ? digits - 1 : digits) << '\n';
  }
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + path);
  }
}
} // namespace tissue
