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
    const auto end = std::to_chars(text, text + sizeof(text), value, std::chars_format::fixed).ptr;
    file << name << " = " << std::string(text, end) << '\n';
  }
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + path);
  }
}
} // namespace tissue
