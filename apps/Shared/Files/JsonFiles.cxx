/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/JsonFiles.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <stdexcept>

namespace tissue
{
void
WriteJson(const nlohmann::ordered_json & json, const std::string & path)
{
  std::ofstream file(path);
  file << json.dump(2) << '\n';
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + path);
  }
}
} // namespace tissue
