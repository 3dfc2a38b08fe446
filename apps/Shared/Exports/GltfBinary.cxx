/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Exports/GltfBinary.h"

#include "TissueTessellationCore/Geometry/Box.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <nlohmann/json.hpp>

#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace tissue
{
namespace
{
using Json = nlohmann::ordered_json;

// Numbers of the standard, and of OpenGL.
constexpr int           floats = 5126;
constexpr int           unsignedInts = 5125;
constexpr int           arrayBuffer = 34962;
constexpr int           elementArrayBuffer = 34963;
constexpr std::uint32_t magic = 0x46546C67;
constexpr std::uint32_t version = 2;
constexpr std::uint32_t jsonChunk = 0x4E4F534A;
constexpr std::uint32_t binaryChunk = 0x004E4942;

Box
BoxOf(const std::vector<ExportedCell> & cells)
{
  if (cells.empty())
  {
    throw std::runtime_error("there are no cells for a .glb");
  }
  Box box{ cells.front().points.front(), cells.front().points.front() };
  for (const ExportedCell & cell : cells)
  {
    for (const Point & point : cell.points)
    {
      Extend(box, point);
    }
  }
  return box;
}

/** The bytes of all arrays, and what the JSON says of them. */
class Buffer
{
public:
  /** Adds a cell's positions and indices; returns the numbers of the two accessors. */
  std::pair<std::size_t, std::size_t>
  Add(const ExportedCell & cell, const Point & middle)
  {
    std::vector<float> positions;
    std::vector<float> lower(3, std::numeric_limits<float>::max());
    std::vector<float> upper(3, std::numeric_limits<float>::lowest());
    for (const Point & point : cell.points)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        positions.push_back(static_cast<float>(point[axis] - middle[axis]));
        lower[axis] = std::min(lower[axis], positions.back());
        upper[axis] = std::max(upper[axis], positions.back());
      }
    }
    std::vector<std::uint32_t> indices;
    for (const Triangle & triangle : cell.triangles)
    {
      indices.insert(indices.end(), triangle.begin(), triangle.end());
    }
    const std::size_t position = this->AddArray(positions, floats, arrayBuffer, cell.points.size(), "VEC3");
    m_Accessors.back()["min"] = lower;
    m_Accessors.back()["max"] = upper;
    return { position, this->AddArray(indices, unsignedInts, elementArrayBuffer, indices.size(), "SCALAR") };
  }

  const std::vector<char> &
  Bytes() const
  {
    return m_Bytes;
  }
  const Json &
  Accessors() const
  {
    return m_Accessors;
  }
  const Json &
  Views() const
  {
    return m_Views;
  }

private:
  template <typename TValue>
  std::size_t
  AddArray(const std::vector<TValue> & values, int componentType, int target, std::size_t count, const char * type)
  {
    const std::size_t offset = m_Bytes.size();
    const std::size_t size = values.size() * sizeof(TValue);
    m_Bytes.resize(offset + size);
    std::memcpy(m_Bytes.data() + offset, values.data(), size);
    m_Accessors.push_back(
      { { "bufferView", m_Views.size() }, { "componentType", componentType }, { "count", count }, { "type", type } });
    m_Views.push_back({ { "buffer", 0 }, { "byteOffset", offset }, { "byteLength", size }, { "target", target } });
    return m_Accessors.size() - 1;
  }

  std::vector<char> m_Bytes;
  Json              m_Accessors = Json::array();
  Json              m_Views = Json::array();
};

void
WriteNumbers(std::ofstream & file, std::initializer_list<std::uint32_t> numbers)
{
  for (const std::uint32_t number : numbers)
  {
    file.write(reinterpret_cast<const char *>(&number), sizeof(number));
  }
}
} // namespace

void
WriteGltfBinary(const std::vector<ExportedCell> & cells, const std::string & path)
{
  const Box   box = BoxOf(cells);
  const Point middle = 0.5 * (box.lower + box.upper);
  Buffer      buffer;
  Json nodes = Json::array({ { { "name", "tissue" }, { "translation", middle }, { "children", Json::array() } } });
  Json meshes = Json::array();
  Json materials = Json::array();
  for (const ExportedCell & cell : cells)
  {
    const std::string name = "cell_" + std::to_string(cell.label);
    const auto [position, indices] = buffer.Add(cell, middle);
    Json color = Json::array();
    for (const unsigned char channel : cell.color)
    {
      color.push_back(std::pow(channel / 255.0, 2.2)); // Factors are linear.
    }
    color.push_back(1.0);
    nodes[0]["children"].push_back(nodes.size());
    nodes.push_back({ { "name", name }, { "mesh", meshes.size() } });
    meshes.push_back({ { "name", name },
                       { "primitives",
                         Json::array({ { { "attributes", { { "POSITION", position } } },
                                         { "indices", indices },
                                         { "material", materials.size() } } }) } });
    materials.push_back(
      { { "name", name },
        { "pbrMetallicRoughness",
          { { "baseColorFactor", color }, { "metallicFactor", 0.0 }, { "roughnessFactor", 0.8 } } } });
  }
  std::vector<char> binary = buffer.Bytes();
  const Json        json{ { "asset", { { "version", "2.0" }, { "generator", "TissueTessellation" } } },
                   { "scene", 0 },
                   { "scenes", Json::array({ { { "nodes", { 0 } } } }) },
                   { "nodes", nodes },
                   { "meshes", meshes },
                   { "materials", materials },
                   { "accessors", buffer.Accessors() },
                   { "bufferViews", buffer.Views() },
                   { "buffers", Json::array({ { { "byteLength", binary.size() } } }) } };
  std::string       text = json.dump();
  // Chunks are padded to words.
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::size_t size = 12 + 8 + text.size() + 8 + binary.size();
  if (size > std::numeric_limits<std::uint32_t>::max())
  {
    throw std::runtime_error("a .glb holds 4 GiB at most, this one would have " + std::to_string(size) + " bytes");
  }
  std::ofstream file(path, std::ios::binary);
  WriteNumbers(file, { magic, version, static_cast<std::uint32_t>(size) });
  WriteNumbers(file, { static_cast<std::uint32_t>(text.size()), jsonChunk });
  file << text;
  WriteNumbers(file, { static_cast<std::uint32_t>(binary.size()), binaryChunk });
  file.write(binary.data(), static_cast<std::streamsize>(binary.size()));
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + path);
  }
}
} // namespace tissue
