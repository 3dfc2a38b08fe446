/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef JsonFiles_h
#define JsonFiles_h

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tissue
{
/** Writes JSON, indented by two blanks, with a line end. \throws std::runtime_error where it cannot. */
void
WriteJson(const nlohmann::ordered_json & json, const std::string & path);
} // namespace tissue

#endif
