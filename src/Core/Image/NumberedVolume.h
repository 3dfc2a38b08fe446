/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_NumberedVolume_h
#define TissueTessellationCore_NumberedVolume_h

#include "TissueTessellationCore/Image/LabelVolume.h"

namespace tissue
{
/** \brief A label volume whose vertices are read by other numbers: numbers[v] for v, or v itself. It refers to both. */
class NumberedVolume
{
public:
  NumberedVolume(const LabelVolume & volume)
    : m_Volume(volume)
  {}

  NumberedVolume(const LabelVolume & volume, const std::vector<VertexId> & numbers)
    : m_Volume(volume)
    , m_Numbers(numbers.data())
  {}

  VertexId
  At(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    const VertexId v = m_Volume.At(x, y, z);
    return m_Numbers != nullptr ? m_Numbers[v] : v;
  }

  /** For all but the vertices. */
  const LabelVolume &
  GetVolume() const
  {
    return m_Volume;
  }

private:
  const LabelVolume & m_Volume;
  const VertexId *    m_Numbers = nullptr;
};
} // namespace tissue

#endif
