/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef NumberFile_h
#define NumberFile_h

#include "TissueTessellationCore/Common/Types.h"

#include <fstream>
#include <limits>
#include <locale>
#include <stdexcept>
#include <string>

namespace tissue
{
/** \brief A text file of numbers that read back as they are, whatever the language of the machine. */
class NumberFile
{
public:
  explicit NumberFile(const std::string & path)
    : m_Path(path)
    , m_File(path, std::ios::binary)
  {
    m_File.imbue(std::locale::classic());
    m_File.precision(std::numeric_limits<double>::max_digits10);
  }

  template <typename TValue>
  NumberFile &
  operator<<(const TValue & value)
  {
    m_File << value;
    return *this;
  }

  NumberFile &
  operator<<(const Point & point)
  {
    m_File << point[0] << ' ' << point[1] << ' ' << point[2];
    return *this;
  }

  /** \throws std::runtime_error where not all could be written. */
  void
  Close()
  {
    if (!m_File.flush())
    {
      throw std::runtime_error("cannot write " + m_Path);
    }
  }

private:
  std::string   m_Path;
  std::ofstream m_File;
};
} // namespace tissue

#endif
