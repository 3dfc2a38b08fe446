/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "OMELayout.h"

#include "LengthUnit.h"

#include <expat.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <type_traits>

namespace tissue
{
namespace
{
using Attributes = std::map<std::string, std::string>;

/** A block of planes. */
struct Block
{
  Attributes  attributes;
  std::string uuid;
  std::string fileName;
};

/** What is collected of the XML. */
struct Document
{
  std::string        uuid;
  std::size_t        numberOfImages = 0;
  Attributes         pixels;
  std::size_t        samplesOfChannel = 1;
  std::vector<Block> blocks;
  bool               isInUUID = false;
  XML_Parser         parser = nullptr;
};

/** Without the prefix of a namespace. */
std::string
LocalName(const char * name)
{
  const std::string text = name;
  return text.substr(text.rfind(':') + 1);
}

std::string
Get(const Attributes & attributes, const std::string & name)
{
  const auto found = attributes.find(name);
  return found != attributes.end() ? found->second : std::string();
}

/** A whole number; `otherwise` where the attribute is absent. */
std::size_t
GetNumber(const Attributes & attributes, const std::string & name, std::size_t otherwise)
{
  const std::string text = Get(attributes, name);
  if (text.empty())
  {
    return otherwise;
  }
  if (text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos)
  {
    throw std::runtime_error("the OME-XML has " + name + "=\"" + text + "\"");
  }
  return std::stoul(text);
}

void
StartElement(void * data, const char * element, const char ** values)
{
  auto &            document = *static_cast<Document *>(data);
  const std::string name = LocalName(element);
  Attributes        attributes;
  for (; *values != nullptr; values += 2)
  {
    attributes[LocalName(values[0])] = values[1];
  }
  if (name == "OME")
  {
    document.uuid = Get(attributes, "UUID");
  }
  document.numberOfImages += name == "Image" ? 1 : 0;
  if (document.numberOfImages != 1)
  {
    return;
  }
  if (name == "Pixels")
  {
    document.pixels = attributes;
  }
  else if (name == "Channel")
  {
    const std::string samples = Get(attributes, "SamplesPerPixel");
    document.samplesOfChannel = samples.size() == 1 && samples > "0" ? samples[0] - '0' : document.samplesOfChannel;
  }
  else if (name == "TiffData")
  {
    document.blocks.push_back({ attributes, {}, {} });
  }
  else if (name == "UUID" && !document.blocks.empty())
  {
    document.blocks.back().fileName = Get(attributes, "FileName");
    document.isInUUID = true;
  }
}

void
EndElement(void * data, const char *)
{
  static_cast<Document *>(data)->isInUUID = false;
}

void
AddText(void * data, const char * text, int length)
{
  auto & document = *static_cast<Document *>(data);
  if (document.isInUUID)
  {
    document.blocks.back().uuid.append(text, static_cast<std::size_t>(length));
  }
}

/** OME-XML declares none: those of a file could be many times longer than it. */
void
RefuseEntity(void * data, const char *, int, const char *, int, const char *, const char *, const char *, const char *)
{
  XML_StopParser(static_cast<Document *>(data)->parser, XML_FALSE);
}

Document
Parse(const std::string & xml)
{
  Document                                                                       document;
  const std::unique_ptr<std::remove_pointer_t<XML_Parser>, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr),
                                                                                        XML_ParserFree);
  document.parser = parser.get();
  XML_SetUserData(parser.get(), &document);
  XML_SetElementHandler(parser.get(), StartElement, EndElement);
  XML_SetCharacterDataHandler(parser.get(), AddText);
  XML_SetEntityDeclHandler(parser.get(), RefuseEntity);
  if (XML_Parse(parser.get(), xml.data(), static_cast<int>(xml.size()), 1) == XML_STATUS_ERROR)
  {
    throw std::runtime_error(std::string("the OME-XML of the TIFF file is broken: ") +
                             XML_ErrorString(XML_GetErrorCode(parser.get())) + " in line " +
                             std::to_string(XML_GetCurrentLineNumber(parser.get())));
  }
  return document;
}

/** Whether each block is of this file. */
std::vector<bool>
FindOwnBlocks(const Document & document, const std::string & fileName)
{
  std::set<std::string> files;
  for (const Block & block : document.blocks)
  {
    files.insert(block.uuid + block.fileName);
  }
  std::vector<bool> own;
  for (const Block & block : document.blocks)
  {
    const bool isNamed = !block.uuid.empty() && block.uuid == document.uuid;
    own.push_back(files.size() == 1 || block.uuid + block.fileName == "" || isNamed || block.fileName == fileName);
  }
  return own;
}

/** The planes' numbers in the order of the dimensions that the XML tells: channels fastest in the result. */
class PlaneOrder
{
public:
  PlaneOrder(const std::string & order, const StackLayout & layout)
  {
    for (const char name : order.substr(std::min<std::size_t>(2, order.size())))
    {
      const std::size_t size = name == 'C'   ? layout.numberOfChannels
                               : name == 'Z' ? layout.numberOfSlices
                                             : layout.numberOfFrames;
      m_Axes.push_back({ name, size });
    }
    m_InOrder = MakeStackLayout(m_Axes);
  }

  /** The number of a plane in the order. */
  std::size_t
  Rank(std::size_t channel, std::size_t slice, std::size_t frame) const
  {
    return static_cast<std::size_t>(m_InOrder.PageOf(channel, slice, frame));
  }

  /** Where in StackLayout::pages the plane of each rank is. */
  std::vector<std::size_t>
  Places() const
  {
    std::vector<std::size_t> places(m_InOrder.pages.size());
    for (std::size_t place = 0; place < places.size(); ++place)
    {
      places[static_cast<std::size_t>(m_InOrder.pages[place])] = place;
    }
    return places;
  }

private:
  std::vector<StackAxis> m_Axes;
  StackLayout            m_InOrder;
};

void
PlaceBlocks(const Document & document, const std::string & fileName, StackLayout & layout)
{
  const PlaneOrder               order(Get(document.pixels, "DimensionOrder"), layout);
  const std::vector<std::size_t> places = order.Places();
  const std::vector<bool>        own = FindOwnBlocks(document, fileName);
  layout.pages.assign(places.size(), -1);
  for (std::size_t b = 0; b < document.blocks.size(); ++b)
  {
    const Attributes & block = document.blocks[b].attributes;
    const std::size_t  channel = GetNumber(block, "FirstC", 0) / document.samplesOfChannel;
    const std::size_t  slice = GetNumber(block, "FirstZ", 0);
    const std::size_t  frame = GetNumber(block, "FirstT", 0);
    if (channel >= layout.numberOfChannels || slice >= layout.numberOfSlices || frame >= layout.numberOfFrames)
    {
      throw std::runtime_error("the OME-XML has a plane outside of its sizes");
    }
    const std::size_t first = order.Rank(channel, slice, frame);
    const std::size_t page = GetNumber(block, "IFD", 0);
    const bool        isOnePlane = block.count("IFD") > 0;
    const std::size_t count = GetNumber(block, "PlaneCount", isOnePlane ? 1 : places.size() - first);
    for (std::size_t i = 0; own[b] && i < std::min(count, places.size() - first); ++i)
    {
      layout.pages[places[first + i]] = static_cast<std::ptrdiff_t>(page + i);
    }
  }
}
/** x, y, z in micrometres, where they are told in a unit of length. */
std::array<std::optional<double>, 3>
FindPhysicalSizes(const Attributes & pixels)
{
  std::array<std::optional<double>, 3> sizes;
  const char                           axes[] = { 'X', 'Y', 'Z' };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::string name = std::string("PhysicalSize") + axes[axis];
    const std::string unit = Get(pixels, name + "Unit");
    const auto        micrometers = ToMicrometers(unit.empty() ? "um" : unit);
    const std::string size = Get(pixels, name);
    if (micrometers && !size.empty())
    {
      sizes[axis] = std::strtod(size.c_str(), nullptr) * *micrometers;
    }
  }
  return sizes;
}
} // namespace

std::optional<StackLayout>
ReadOMELayout(const std::string & xml, const std::string & fileName)
{
  if (xml.find("OME") == std::string::npos)
  {
    return std::nullopt;
  }
  Document document = Parse(xml);
  if (document.pixels.empty())
  {
    return std::nullopt;
  }
  if (document.blocks.empty())
  {
    // All planes are in this file then, in their order.
    document.blocks.resize(1);
  }
  const auto count = [&](const char * name) { return std::max<std::size_t>(1, GetNumber(document.pixels, name, 1)); };
  const std::size_t channels = std::max<std::size_t>(1, count("SizeC") / document.samplesOfChannel);
  StackLayout       layout = MakeStackLayout({ { 'C', channels }, { 'Z', count("SizeZ") }, { 'T', count("SizeT") } });
  const std::string order = Get(document.pixels, "DimensionOrder");
  if (order.size() != 5 || !std::is_permutation(order.begin() + 2, order.end(), "CZT"))
  {
    throw std::runtime_error("the OME-XML has DimensionOrder=\"" + order + "\"");
  }
  PlaceBlocks(document, fileName, layout);
  layout.voxelSize = FindPhysicalSizes(document.pixels);
  if (document.numberOfImages > 1)
  {
    layout.warnings.push_back("the OME-TIFF file has " + std::to_string(document.numberOfImages) +
                              " images, of which the first is read");
  }
  return layout;
}
} // namespace tissue
