/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/TextDecoding.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>

namespace tissue
{
namespace
{
std::uint32_t
ByteAt(const std::string & bytes, std::size_t i)
{
  return static_cast<unsigned char>(bytes[i]);
}

bool
IsSurrogate(std::uint32_t code)
{
  return code >= 0xD800 && code < 0xE000;
}

/** Strictly: no character in more bytes than it needs, none beyond Unicode. */
bool
IsUTF8(const std::string & bytes)
{
  constexpr std::uint32_t least[] = { 0, 0x80, 0x800, 0x10000 };
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    const std::uint32_t first = ByteAt(bytes, i);
    const int more = first < 0x80 ? 0 : (first >> 5) == 6 ? 1 : (first >> 4) == 14 ? 2 : (first >> 3) == 30 ? 3 : -1;
    if (more < 0 || i + static_cast<std::size_t>(more) >= bytes.size())
    {
      return false;
    }
    std::uint32_t code = more == 0 ? first : first & (0x3Fu >> more);
    for (int k = 0; k < more; ++k)
    {
      const std::uint32_t next = ByteAt(bytes, ++i);
      if ((next >> 6) != 2)
      {
        return false;
      }
      code = (code << 6) | (next & 0x3F);
    }
    if (code < least[more] || IsSurrogate(code) || code > 0x10FFFF)
    {
      return false;
    }
  }
  return true;
}

void
AppendUTF8(std::uint32_t code, std::string & text)
{
  const auto append = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80)
  {
    append(code);
    return;
  }
  const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  append(((0xFF00u >> (more + 1)) & 0xFF) | (code >> (6 * more)));
  for (int k = more - 1; k >= 0; --k)
  {
    append(0x80 | ((code >> (6 * k)) & 0x3F));
  }
}

/** \param high the place of the more significant byte in each pair. */
std::string
DecodeUTF16(const std::string & bytes, std::size_t begin, std::size_t high)
{
  if ((bytes.size() - begin) % 2 != 0)
  {
    throw std::runtime_error("the text is in UTF-16, but ends within a character: is the file cut off?");
  }
  const auto  unitAt = [&](std::size_t i) { return (ByteAt(bytes, i + high) << 8) | ByteAt(bytes, i + 1 - high); };
  std::string text;
  for (std::size_t i = begin; i < bytes.size(); i += 2)
  {
    std::uint32_t code = unitAt(i);
    if (IsSurrogate(code))
    {
      const std::uint32_t second = i + 2 < bytes.size() ? unitAt(i + 2) : 0;
      if (code >= 0xDC00 || (second >> 10) != 0x37)
      {
        throw std::runtime_error("the text is in UTF-16, but has half a character at byte " + std::to_string(i));
      }
      code = 0x10000 + ((code - 0xD800) << 10) + (second - 0xDC00);
      i += 2;
    }
    AppendUTF8(code, text);
  }
  return text;
}

/** Which byte of each pair is zero in most of a text without a mark; nothing where neither is. */
std::optional<std::size_t>
FindZeroBytes(const std::string & bytes)
{
  std::size_t counts[2] = { 0, 0 };
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    counts[i % 2] += bytes[i] == '\0' ? 1 : 0;
  }
  const std::size_t high = counts[0] > counts[1] ? 0 : 1;
  const bool        isUTF16 = counts[1 - high] == 0 && 10 * counts[high] >= 9 * (bytes.size() / 2);
  return isUTF16 && bytes.size() >= 2 ? std::make_optional(high) : std::nullopt;
}

std::string
DecodeLatin1(const std::string & bytes)
{
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    AppendUTF8(ByteAt(bytes, i), text);
  }
  return text;
}
} // namespace

std::string
DecodeText(const std::string & bytes)
{
  const auto  beginsWith = [&bytes](const char * mark, std::size_t size) { return bytes.compare(0, size, mark) == 0; };
  std::string text;
  if (beginsWith("\xEF\xBB\xBF", 3))
  {
    text = bytes.substr(3);
  }
  else if (beginsWith("\xFF\xFE", 2))
  {
    text = DecodeUTF16(bytes, 2, 1);
  }
  else if (beginsWith("\xFE\xFF", 2))
  {
    text = DecodeUTF16(bytes, 2, 0);
  }
  else if (const auto high = FindZeroBytes(bytes))
  {
    text = DecodeUTF16(bytes, 0, *high);
  }
  else
  {
    text = bytes;
  }
  if (text.find('\0') != std::string::npos)
  {
    throw std::runtime_error("there are zero bytes, must be text in UTF-8, UTF-16 or Latin-1");
  }
  return IsUTF8(text) ? text : DecodeLatin1(text);
}
} // namespace tissue
