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
/** Calls visit with a value, 0, of the type in which labels of a file's integer type are read. */
template <typename TVisitor>
void
VisitPixelType(itk::IOComponentEnum type, const TVisitor & visit)
{
  switch (type)
  {
    case itk::IOComponentEnum::UCHAR:
      visit(static_cast<unsigned char>(0));
      break;
    case itk::IOComponentEnum::CHAR:
      visit(static_cast<signed char>(0));
      break;
    case itk::IOComponentEnum::USHORT:
      visit(static_cast<unsigned short>(0));
      break;
    case itk::IOComponentEnum::SHORT:
      visit(static_cast<short>(0));
      break;
    case itk::IOComponentEnum::UINT:
      visit(0u);
      break;
    case itk::IOComponentEnum::INT:
      visit(0);
      break;
    case itk::IOComponentEnum::ULONG:
    case itk::IOComponentEnum::ULONGLONG:
      visit(0ull);
      break;
    default:
      visit(0ll);
  }
}
} // namespace tissue

#endif
