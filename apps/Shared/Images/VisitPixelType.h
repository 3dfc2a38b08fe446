/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef VisitPixelType_h
#define VisitPixelType_h

#include <itkCommonEnums.h>

namespace tissue
{
/** Calls visit with a value, 0, of the type in which labels of a file's integer type are read. Returns what it returns,
 * which is of one type for all of them. */
template <typename TVisitor>
auto
VisitPixelType(itk::IOComponentEnum type, const TVisitor & visit)
{
  switch (type)
  {
    case itk::IOComponentEnum::UCHAR:
      return visit(static_cast<unsigned char>(0));
    case itk::IOComponentEnum::CHAR:
      return visit(static_cast<signed char>(0));
    case itk::IOComponentEnum::USHORT:
      return visit(static_cast<unsigned short>(0));
    case itk::IOComponentEnum::SHORT:
      return visit(static_cast<short>(0));
    case itk::IOComponentEnum::UINT:
      return visit(0u);
    case itk::IOComponentEnum::INT:
      return visit(0);
    case itk::IOComponentEnum::ULONG:
    case itk::IOComponentEnum::ULONGLONG:
      return visit(0ull);
    default:
      return visit(0ll);
  }
}
} // namespace tissue

#endif
