/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef RandomLabelImage_h
#define RandomLabelImage_h

#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Image/LabelVolume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace tissue_test
{
using namespace tissue;

/** \brief Small label images of all kinds, sound and not, each of them by its seed alone. */
class RandomLabelImage
{
public:
  static constexpr const char * Kinds[] = { "uniform noise", "Voronoi",   "checkerboard",   "salt and pepper",
                                            "snakes",        "shells",    "torus",          "rods",
                                            "pieces",        "one giant", "all distinct",   "few labels",
                                            "nested",        "diagonals", "sheet of cells", "holes" };
  static constexpr int          NumberOfKinds = static_cast<int>(sizeof(Kinds) / sizeof(Kinds[0]));

  explicit RandomLabelImage(std::uint64_t seed)
    : m_Random(seed * 2654435761u + 1)
    , m_Kind(static_cast<int>(seed % NumberOfKinds))
  {
    constexpr int longest = 16;
    for (std::int32_t & side : m_Size)
    {
      side = 1 + static_cast<std::int32_t>(m_Random.Index(longest));
    }
    m_Labels.resize(static_cast<std::size_t>(m_Size[0]) * m_Size[1] * m_Size[2], 0);
    // Of some images the exterior is the outside alone, of some it is around the tissue.
    m_Margin = m_Random.Uniform() < 0.5 ? 1 : 0;
    this->Draw();
    // Isotropic, or longer by up to twenty along one axis.
    const std::size_t axis = m_Random.Index(3);
    m_Spacing[axis] = m_Random.Uniform() < 0.5 ? 1.0 : 1.0 + 19.0 * m_Random.Uniform();
  }

  const char *
  GetKind() const
  {
    return Kinds[m_Kind];
  }

  /** Of vertices without gaps, 0 being the exterior. */
  LabelVolume
  MakeVolume() const
  {
    std::map<int, VertexId> vertexOf{ { 0, ExteriorVertex } };
    for (const int label : m_Labels)
    {
      vertexOf.emplace(label, 0);
    }
    VertexId last = ExteriorVertex;
    for (auto & [label, vertex] : vertexOf)
    {
      vertex = label == 0 ? ExteriorVertex : ++last;
    }
    LabelVolume volume;
    volume.size = m_Size;
    volume.vertices = VoxelVertices(m_Labels.size(), ExteriorVertex, last);
    for (std::size_t i = 0; i < m_Labels.size(); ++i)
    {
      volume.vertices.Put(i, vertexOf.at(m_Labels[i]));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      volume.steps[axis][axis] = m_Spacing[axis];
    }
    return volume;
  }

private:
  using Index = std::array<int, 3>;

  void
  Draw()
  {
    switch (m_Kind)
    {
      case 0:
        return this->DrawNoise(1 + static_cast<int>(m_Random.Index(40)));
      case 1:
        return this->DrawVoronoi(1);
      case 2:
        return this->DrawCheckerboard();
      case 3:
        this->DrawVoronoi(1);
        return this->Sprinkle(m_Random.Uniform() * 0.2);
      case 4:
        return this->DrawSnakes();
      case 5:
        return this->DrawShells();
      case 6:
        return this->DrawTorus();
      case 7:
        return this->DrawRods();
      case 8:
        return this->DrawVoronoi(2 + static_cast<int>(m_Random.Index(3)));
      case 9:
        this->ForEach([](const Index &) { return 1; });
        return this->Sprinkle(m_Random.Uniform() * 0.1);
      case 10:
        return this->ForEach([n = 0](const Index &) mutable { return ++n; });
      case 11:
        return this->DrawNoise(1 + static_cast<int>(m_Random.Index(3)));
      case 12:
        return this->DrawNested();
      case 13:
        return this->DrawDiagonals();
      case 14:
        return this->DrawSheet();
      default:
        this->DrawVoronoi(1);
        return this->DrawHoles();
    }
  }

  int &
  At(const Index & i)
  {
    return m_Labels[(static_cast<std::size_t>(i[2]) * m_Size[1] + i[1]) * m_Size[0] + i[0]];
  }

  bool
  IsInMargin(const Index & i) const
  {
    bool isIn = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      isIn = isIn || i[axis] < m_Margin || i[axis] >= m_Size[axis] - m_Margin;
    }
    return isIn;
  }

  /** Labels all voxels but those of the margin. */
  template <typename TFunction>
  void
  ForEach(TFunction labelAt)
  {
    Index i;
    for (i[2] = 0; i[2] < m_Size[2]; ++i[2])
    {
      for (i[1] = 0; i[1] < m_Size[1]; ++i[1])
      {
        for (i[0] = 0; i[0] < m_Size[0]; ++i[0])
        {
          this->At(i) = this->IsInMargin(i) ? 0 : labelAt(i);
        }
      }
    }
  }

  Index
  AnyIndex()
  {
    Index i;
    for (int axis = 0; axis < 3; ++axis)
    {
      i[axis] = static_cast<int>(m_Random.Index(static_cast<std::size_t>(m_Size[axis])));
    }
    return i;
  }

  static int
  SquaredDistance(const Index & a, const Index & b)
  {
    int sum = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    }
    return sum;
  }

  /** The distance from the middle of the image, in half its sides. */
  double
  RadiusOf(const Index & i) const
  {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double half = 0.5 * m_Size[axis];
      sum += (i[axis] + 0.5 - half) * (i[axis] + 0.5 - half) / (half * half);
    }
    return std::sqrt(sum);
  }

  void
  DrawNoise(int count)
  {
    const int first = static_cast<int>(m_Random.Index(2));
    this->ForEach(
      [&](const Index &) { return first + static_cast<int>(m_Random.Index(static_cast<std::size_t>(count))); });
  }

  /** Cells of the nearest of some points, `pieces` of which share a label; one label in six is the exterior's. */
  void
  DrawVoronoi(int pieces)
  {
    const int          count = pieces * (1 + static_cast<int>(m_Random.Index(30)));
    std::vector<Index> seeds;
    for (int s = 0; s < count; ++s)
    {
      seeds.push_back(this->AnyIndex());
    }
    const bool hasHoles = m_Random.Uniform() < 0.3;
    this->ForEach([&](const Index & i) {
      const auto nearest = std::min_element(seeds.begin(), seeds.end(), [&](const Index & a, const Index & b) {
        return SquaredDistance(a, i) < SquaredDistance(b, i);
      });
      const int  label = 1 + static_cast<int>(nearest - seeds.begin()) / pieces;
      return hasHoles && label % 6 == 0 ? 0 : label;
    });
  }

  void
  DrawCheckerboard()
  {
    const int  step = 1 + static_cast<int>(m_Random.Index(4));
    const auto count = 2 + static_cast<int>(m_Random.Index(7));
    const int  first = static_cast<int>(m_Random.Index(2));
    this->ForEach(
      [&](const Index & i) { return first + (i[0] / step + 3 * (i[1] / step) + 5 * (i[2] / step)) % count; });
  }

  void
  Sprinkle(double share)
  {
    const std::vector<int> labels = m_Labels;
    const bool             isNew = m_Random.Uniform() < 0.5;
    int                    last = *std::max_element(labels.begin(), labels.end());
    for (int & label : m_Labels)
    {
      if (m_Random.Uniform() < share)
      {
        label = isNew ? ++last : labels[m_Random.Index(labels.size())];
      }
    }
  }

  void
  DrawSnakes()
  {
    const int count = 1 + static_cast<int>(m_Random.Index(12));
    for (int s = 1; s <= count; ++s)
    {
      Index     i = this->AnyIndex();
      const int length = 1 + static_cast<int>(m_Random.Index(60));
      for (int step = 0; step < length; ++step)
      {
        this->At(i) = s;
        const std::size_t axis = m_Random.Index(3);
        i[axis] = std::clamp(i[axis] + (m_Random.Uniform() < 0.5 ? 1 : -1), 0, m_Size[axis] - 1);
      }
    }
  }

  void
  DrawShells()
  {
    const double width = 0.15 + 0.4 * m_Random.Uniform();
    const int    parts = 1 + static_cast<int>(m_Random.Index(3));
    this->ForEach([&](const Index & i) {
      const double radius = this->RadiusOf(i);
      const int    shell = static_cast<int>(radius / width);
      const int    part = parts == 1 ? 0 : (i[0] * 2 >= m_Size[0]) + (parts == 3 && i[1] * 2 >= m_Size[1] ? 2 : 0);
      return radius > 1.0 ? 0 : shell % 3 == 2 ? 0 : 1 + 4 * shell + part;
    });
  }

  void
  DrawTorus()
  {
    const double inner = 0.3 + 0.3 * m_Random.Uniform();
    const int    parts = static_cast<int>(m_Random.Index(5));
    const int    core = static_cast<int>(m_Random.Index(3));
    this->ForEach([&](const Index & i) {
      const double x = (i[0] + 0.5) / (0.5 * m_Size[0]) - 1.0;
      const double y = (i[1] + 0.5) / (0.5 * m_Size[1]) - 1.0;
      const double radius = std::sqrt(x * x + y * y);
      const double share = std::atan2(y, x) / 6.2831853 + 0.5;
      return radius > 1.0     ? (core == 2 ? 20 : 0)
             : radius < inner ? (core > 0 ? 10 : 0)
                              : 1 + static_cast<int>(share * parts);
    });
  }

  void
  DrawRods()
  {
    const int count = 1 + static_cast<int>(m_Random.Index(15));
    for (int s = 1; s <= count; ++s)
    {
      const Index       from = this->AnyIndex();
      const std::size_t axis = m_Random.Index(3);
      const int         thick = static_cast<int>(m_Random.Index(2));
      Index             i = from;
      for (i[axis] = 0; i[axis] < m_Size[axis]; ++i[axis])
      {
        for (int side = 0; side <= thick; ++side)
        {
          const std::size_t other = (axis + 1) % 3;
          i[other] = std::min(from[other] + side, m_Size[other] - 1);
          this->At(i) = s;
        }
      }
    }
  }

  void
  DrawNested()
  {
    const int thick = 1 + static_cast<int>(m_Random.Index(3));
    const int split = static_cast<int>(m_Random.Index(3));
    this->ForEach([&](const Index & i) {
      int depth = 100;
      for (int axis = 0; axis < 3; ++axis)
      {
        depth = std::min({ depth, i[axis], m_Size[axis] - 1 - i[axis] });
      }
      return 1 + 2 * (depth / thick) + (split == 1 && i[2] * 2 >= m_Size[2] ? 1 : 0);
    });
  }

  /** Cells that meet at edges and corners of voxels only. */
  void
  DrawDiagonals()
  {
    const int size = 1 + static_cast<int>(m_Random.Index(3));
    const int period = 2 + static_cast<int>(m_Random.Index(2));
    this->ForEach([&](const Index & i) {
      const Index block{ { i[0] / size, i[1] / size, i[2] / size } };
      const bool  isCell = (block[0] + block[1] + block[2]) % period == 0;
      return isCell ? 1 + block[0] + 17 * block[1] + 17 * 17 * block[2] : 0;
    });
  }

  void
  DrawSheet()
  {
    const std::size_t axis = m_Random.Index(3);
    const int         at = static_cast<int>(m_Random.Index(static_cast<std::size_t>(m_Size[axis])));
    const int         thick = 1 + static_cast<int>(m_Random.Index(4));
    const int         step = 1 + static_cast<int>(m_Random.Index(6));
    this->ForEach([&](const Index & i) {
      const int bent = at + (i[(axis + 1) % 3] + i[(axis + 2) % 3]) / 7;
      return std::abs(i[axis] - bent) < thick ? 1 + i[(axis + 1) % 3] / step + 17 * (i[(axis + 2) % 3] / step) : 0;
    });
  }

  void
  DrawHoles()
  {
    const int count = 1 + static_cast<int>(m_Random.Index(20));
    for (int hole = 0; hole < count; ++hole)
    {
      this->At(this->AnyIndex()) = 0;
    }
  }

  Random                      m_Random;
  int                         m_Kind;
  std::array<std::int32_t, 3> m_Size{};
  int                         m_Margin = 0;
  std::vector<int>            m_Labels;
  Point                       m_Spacing{ { 1.0, 1.0, 1.0 } };
};
} // namespace tissue_test

#endif
