/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "StackLayout.h"

#include "LengthUnit.h"
#include "OMELayout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
using Properties = std::map<std::string, std::string>;

std::optional<double>
ToNumber(const std::string & text)
{
  try
  {
    return std::stod(text);
  }
  catch (const std::exception &)
  {
    return std::nullopt;
  }
}

/** A number of channels, slices or frames; one where it is absent. */
std::size_t
CountOf(const Properties & properties, const std::string & name)
{
  const auto found = properties.find(name);
  if (found == properties.end())
  {
    return 1;
  }
  const std::optional<double> number = ToNumber(found->second);
  if (!number || !(*number >= 1.0 && *number < 1e9))
  {
    throw std::runtime_error("the description of ImageJ has '" + name + "=" + found->second + "'");
  }
  return static_cast<std::size_t>(*number);
}

Properties
ReadProperties(const std::string & description)
{
  Properties         properties;
  std::istringstream lines(description);
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos)
    {
      line.erase(line.find_last_not_of(" \r") + 1);
      properties[line.substr(0, equals)] = line.substr(equals + 1);
    }
  }
  return properties;
}

StackLayout
ReadImageJLayout(const std::string & description)
{
  const Properties  properties = ReadProperties(description);
  const std::size_t images = CountOf(properties, "images");
  const std::size_t channels = CountOf(properties, "channels");
  std::size_t       slices = CountOf(properties, "slices");
  std::size_t       frames = CountOf(properties, "frames");
  // Plain stacks tell their images alone, films of them their frames' rate as well.
  if (channels * slices * frames == 1)
  {
    slices = images;
  }
  if (properties.count("images") > 0 && images != channels * slices * frames)
  {
    throw std::runtime_error("the description of ImageJ has " + std::to_string(images) + " images, but " +
                             std::to_string(channels) + " channels of " + std::to_string(slices) + " slices and " +
                             std::to_string(frames) + " frames");
  }
  StackLayout layout = MakeStackLayout({ { 'C', channels }, { 'Z', slices }, { 'T', frames } });
  const auto  text = [&properties](const std::string & name) {
    const auto found = properties.find(name);
    return found != properties.end() ? found->second : std::string();
  };
  layout.unit = text("unit");
  const std::optional<double> distance = ToNumber(text("spacing"));
  if (distance && *distance != 0.0)
  {
    const auto unit = ToMicrometers(layout.unit);
    const auto ofSlices = ToMicrometers(text("zunit"));
    layout.sliceDistance = std::abs(*distance) * (unit && ofSlices ? *ofSlices / *unit : 1.0);
  }
  return layout;
}

/** The text after a name in JSON that a pattern matches; empty where there is none. */
std::string
FindInJson(const std::string & json, const std::string & name, const std::string & pattern)
{
  std::smatch match;
  return std::regex_search(json, match, std::regex("\"" + name + "\"\\s*:\\s*" + pattern)) ? match[1].str() : "";
}

/** The axes before the rows and columns, fastest first. */
std::vector<StackAxis>
ToStackAxes(const std::vector<std::size_t> & sizes, const std::string & names)
{
  std::vector<StackAxis> axes;
  const bool             hasZ = names.find('Z') != std::string::npos;
  bool                   isFirst = true;
  for (std::size_t i = sizes.size(); i-- > 0;)
  {
    if (sizes[i] == 1)
    {
      continue;
    }
    const char name = i < names.size() ? names[i] : '?';
    const bool isKnown = name == 'C' || name == 'Z' || name == 'T' || name == 'S';
    const char other = isFirst && !hasZ ? 'Z' : 'T';
    axes.push_back({ name == 'S' ? 'C' : isKnown ? name : other, sizes[i] });
    isFirst = false;
  }
  return axes;
}

/** Of JSON as {"shape": [40, 44, 48], "axes": "ZYX"}; nothing where the planes are not the image's. */
std::optional<StackLayout>
ReadShapedLayout(const std::string & description, const PlaneFormat & plane)
{
  std::vector<std::size_t> shape;
  std::istringstream       numbers(FindInJson(description, "shape", R"(\[([\d,\s]*)\])"));
  for (std::string number; std::getline(numbers, number, ',');)
  {
    shape.push_back(static_cast<std::size_t>(ToNumber(number).value_or(0.0)));
  }
  std::string axes = FindInJson(description, "axes", "\"(\\w*)\"");
  axes = axes.size() == shape.size() ? axes : std::string();
  const auto drop = [&shape, &axes](std::size_t fromEnd) {
    const auto at = static_cast<std::ptrdiff_t>(shape.size() - fromEnd);
    shape.erase(shape.begin() + at);
    axes.erase(axes.begin() + std::min(at, static_cast<std::ptrdiff_t>(axes.size())),
               axes.begin() + std::min(at + 1, static_cast<std::ptrdiff_t>(axes.size())));
  };
  const auto isAt = [&shape](std::size_t fromEnd, std::size_t size) {
    return shape.size() >= fromEnd && shape[shape.size() - fromEnd] == size;
  };
  if (plane.numberOfSamples > 1 && isAt(1, plane.numberOfSamples) && isAt(2, plane.width) && isAt(3, plane.height))
  {
    drop(1);
  }
  else if (plane.numberOfSamples > 1 && isAt(3, plane.numberOfSamples))
  {
    drop(3);
  }
  if (!isAt(1, plane.width) || !isAt(2, plane.height))
  {
    return std::nullopt;
  }
  shape.resize(shape.size() - 2);
  StackLayout layout = MakeStackLayout(ToStackAxes(shape, axes));
  layout.unit = FindInJson(description, "unit", "\"([^\"]*)\"");
  layout.sliceDistance = ToNumber(FindInJson(description, "spacing", R"(([-+.\deE]+))"));
  return layout;
}

/** Channels of one slice are its slices where they are many. */
void
TakeChannelsForSlices(StackLayout & layout)
{
  constexpr std::size_t most = 4;
  if (layout.numberOfSlices == 1 && layout.numberOfFrames == 1 && layout.numberOfChannels > most)
  {
    std::swap(layout.numberOfSlices, layout.numberOfChannels);
    layout.warnings.push_back("the TIFF file calls its " + std::to_string(layout.numberOfSlices) +
                              " planes channels of one slice; they are taken for slices");
  }
}
} // namespace

StackLayout
MakeStackLayout(const std::vector<StackAxis> & fastestFirst)
{
  constexpr std::size_t most = 100'000'000;
  StackLayout           layout;
  std::size_t           total = 1;
  for (const StackAxis & axis : fastestFirst)
  {
    (axis.name == 'C'   ? layout.numberOfChannels
     : axis.name == 'Z' ? layout.numberOfSlices
                        : layout.numberOfFrames) *= axis.size;
    total *= axis.size;
    if (axis.size > most || total > most)
    {
      throw std::runtime_error("the description of the TIFF file tells of more than " + std::to_string(most) +
                               " planes");
    }
  }
  layout.pages.resize(total);
  for (std::size_t page = 0; page < total; ++page)
  {
    // Of axes of the same name the first one is the fastest.
    std::size_t rest = page;
    std::size_t index[3]{};
    std::size_t step[3]{ 1, 1, 1 };
    for (const StackAxis & axis : fastestFirst)
    {
      const int which = axis.name == 'C' ? 0 : axis.name == 'Z' ? 1 : 2;
      index[which] += step[which] * (rest % axis.size);
      step[which] *= axis.size;
      rest /= axis.size;
    }
    layout.pages[(index[2] * layout.numberOfSlices + index[1]) * layout.numberOfChannels + index[0]] =
      static_cast<std::ptrdiff_t>(page);
  }
  return layout;
}

std::optional<StackLayout>
ReadStackLayout(const std::string & description, const PlaneFormat & plane, const std::string & fileName)
{
  std::optional<StackLayout> layout;
  const auto                 start = description.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (description.find("ImageJ=") == 0)
  {
    layout = ReadImageJLayout(description);
  }
  else if (start != std::string::npos && description[start] == '{')
  {
    layout = ReadShapedLayout(description, plane);
  }
  else if (start != std::string::npos && description[start] == '<')
  {
    layout = ReadOMELayout(description.substr(start), fileName);
  }
  if (layout)
  {
    TakeChannelsForSlices(*layout);
  }
  return layout;
}
} // namespace tissue
