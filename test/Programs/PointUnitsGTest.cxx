/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "NucleiTessellation/PointUnits.h"

#include "StackTestFiles.h"

#include <gtest/gtest.h>

namespace
{
/** Eight points that extend over the box from 0.2 to 0.8 of the lengths, 10 x 20 x 30 voxels of 0.5, times a factor. */
std::string
Refusal(double factor, const std::string & pointUnit = "", const std::string & boxUnit = "")
{
  const auto box = itk::ImageBase<3>::New();
  box->SetRegions(itk::Size<3>{ { 10, 20, 30 } });
  const double spacing[] = { 0.5, 0.5, 0.5 };
  box->SetSpacing(spacing);
  std::vector<tissue::Point> points;
  for (const double share : { 0.2, 0.8 })
  {
    points.push_back({ { 5.0 * share * factor, 10.0 * share * factor, 15.0 * share * factor } });
  }
  return WordsOf([&] { tissue::RequireUnitOfBox(points, pointUnit, box, boxUnit); });
}

bool
Has(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}
} // namespace

TEST(PointUnits, AreAnyWherePointsAndBoxAreOfOneSize)
{
  EXPECT_EQ(Refusal(1.0), "");
  EXPECT_EQ(Refusal(0.1), "") << "few cells in a large image";
  EXPECT_EQ(Refusal(1.5), "") << "a point that is a little outside is named elsewhere";
}

TEST(PointUnits, AreSaidWhereTheyDifferByPowersOfTen)
{
  const std::string small = Refusal(1e-3, "mm", "micrometres");
  EXPECT_TRUE(Has(small, "extend over 0.003 x 0.006 x 0.009 mm, the box over 5 x 10 x 15 micrometres")) << small;
  EXPECT_TRUE(Has(small, "10 x 20 x 30 voxels of 0.5 x 0.5 x 0.5")) << small;
  EXPECT_TRUE(Has(small, "as if the points were in millimetres and the box in micrometres")) << small;
  EXPECT_TRUE(Has(small, "--spacing X Y Z")) << small;
  EXPECT_TRUE(Has(Refusal(1e-6), "points were in metres"));
  EXPECT_TRUE(Has(Refusal(4.0), "one were in voxels and the other in micrometres"));
  EXPECT_TRUE(Has(Refusal(1e3), "points were in micrometres and the box in millimetres"));
}
