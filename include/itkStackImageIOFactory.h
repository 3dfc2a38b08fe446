/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkStackImageIOFactory_h
#define itkStackImageIOFactory_h

#include "TissueTessellationExport.h"
#include "itkObjectFactoryBase.h"

namespace itk
{
/** \class StackImageIOFactory
 * \brief Makes StackTIFFImageIO, StackHDF5ImageIO and InrImageIO known to ImageFileReader.
 *
 * \ingroup TissueTessellation
 */
class TissueTessellation_EXPORT StackImageIOFactory : public ObjectFactoryBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(StackImageIOFactory);

  using Self = StackImageIOFactory;
  using Superclass = ObjectFactoryBase;
  using Pointer = SmartPointer<Self>;

  itkFactorylessNewMacro(Self);
  itkTypeMacro(StackImageIOFactory, ObjectFactoryBase);

  const char *
  GetITKSourceVersion() const override;
  const char *
  GetDescription() const override;

  /** Registers the readers, once, before all others: files that they can read are theirs. */
  static void
  RegisterOneFactory();

protected:
  StackImageIOFactory();
  ~StackImageIOFactory() override = default;
};
} // namespace itk

#endif
