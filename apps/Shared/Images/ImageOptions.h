/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ImageOptions_h
#define ImageOptions_h

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

#include <array>
#include <optional>
#include <string>

namespace tissue
{
/** What of an image file is read, and in which units. */
struct ImageOptions
{
  /** Voxel size x, y, z in place of the file's. */
  std::optional<std::array<double, 3>> spacing;
  /** Of a file that has several: from 1 on; 0: none is chosen. */
  unsigned int channel = 0;
  unsigned int frame = 0;
  /** Whether all that holds only where the file needs it: a spacing where it tells none, a channel where it has
   * several. */
  bool isOptional = false;
  /** Whether the channel and the frame must be there all the same. */
  bool requiresChoice = false;
  /** The options that choose, for messages. */
  std::string channelOption = "--channel";
  std::string frameOption = "--frame";

  /** For a further image of the same run, which may be of another file. */
  ImageOptions
  ForFurther() const
  {
    ImageOptions further = *this;
    further.isOptional = true;
    return further;
  }

  /** Whether any is given. */
  bool
  AreGiven() const
  {
    return spacing || channel > 0 || frame > 0;
  }
};

/** Adds --spacing and --channel, the same for all programs. */
void
AddSpacingAndChannel(CLI::App & app, ImageOptions & options);

/** Adds these and --frame. */
void
AddImageOptions(CLI::App & app, ImageOptions & options);

/** The options for the report. */
void
AddToJson(const ImageOptions & options, nlohmann::ordered_json & json);
} // namespace tissue

#endif
