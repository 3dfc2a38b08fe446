/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/PlyPoints.h"

#include "RefusalOf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <sstream>

using namespace tissue;

namespace
{
const std::vector<Point> points{ { { 1.5, -2.0, 3.0 } }, { { 4.0, 5.0, 6.25 } } };

std::string
Header(const std::string & format, const std::string & type)
{
  return "ply\nformat " + format + " 1.0\ncomment made up\nelement vertex 2\nproperty uchar red\nproperty " + type +
         " x\nproperty " + type + " y\nproperty " + type +
         " z\nelement face 0\nproperty list uchar int vertex_indices\n" + "end_header\n";
}

template <typename T>
std::string
InBytes(bool isBigEndian)
{
  std::string bytes;
  for (const Point & point : points)
  {
    bytes += '\7';
    for (const double value : point)
    {
      const T number = static_cast<T>(value);
      char    raw[sizeof(T)];
      std::memcpy(raw, &number, sizeof(T));
      // Of a machine whose least significant byte is the first.
      std::string text(raw, sizeof(T));
      if (isBigEndian)
      {
        std::reverse(text.begin(), text.end());
      }
      bytes += text;
    }
  }
  return bytes;
}

PointFile
Read(const std::string & text)
{
  std::istringstream stream(text);
  return ReadPlyPoints(stream);
}

std::string
Refusal(const std::string & text)
{
  return RefusalOf([&] { Read(text); });
}
} // namespace

TEST(PlyPoints, OfEveryFormat)
{
  const std::string text = "7 1.5 -2 3\r\n7 4 5 6.25\n";
  EXPECT_EQ(Read(Header("ascii", "float") + text).points, points);
  EXPECT_EQ(Read(Header("ascii", "float") + text).places, (std::vector<std::string>{ "vertex 0", "vertex 1" }));
  EXPECT_EQ(Read(Header("binary_little_endian", "float") + InBytes<float>(false)).points, points);
  EXPECT_EQ(Read(Header("binary_big_endian", "double") + InBytes<double>(true)).points, points);
}

TEST(PlyPoints, SaysWhatIsWrong)
{
  EXPECT_EQ(Refusal("no"), "is no PLY: its first line must be 'ply'");
  EXPECT_EQ(Refusal("ply\nformat ascii 1.0\n"), "is cut off");
  EXPECT_EQ(Refusal("ply\nformat text 1.0\nend_header\n"), "the format 'text' is none of PLY");
  EXPECT_EQ(Refusal("ply\nformat ascii 1.0\nend_header\n"), "there is no element 'vertex'");
  EXPECT_EQ(Refusal("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n"),
            "the vertices have no property z");
  EXPECT_EQ(Refusal("ply\nelement vertex many\nend_header\n"),
            "the line 'element vertex many' of the header is not that of a PLY");
  EXPECT_EQ(Refusal(Header("ascii", "float") + "7 1 2 3\n"), "vertex 1: is cut off");
  EXPECT_EQ(Refusal(Header("ascii", "float") + "7 1 2\n"), "vertex 0: there are 3 numbers, must be 4");
  EXPECT_EQ(Refusal(Header("ascii", "float") + "7 1 two 3\n"), "vertex 0: 'two' is no number");
  EXPECT_EQ(Refusal(Header("ascii", "float") + "7 1 nan 3\n"), "vertex 0: its y is nan, must be finite");
  const std::string whole = Header("binary_little_endian", "float") + InBytes<float>(false);
  EXPECT_EQ(Refusal(whole.substr(0, whole.size() - 1)), "vertex 1: is cut off");
  EXPECT_NE(Refusal(Header("binary_little_endian", "half") + "7").find("'x' of the type 'half'"), std::string::npos);
}
