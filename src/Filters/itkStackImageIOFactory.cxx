/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkStackImageIOFactory.h"

#include "itkCreateObjectFunction.h"
#include "itkInrImageIO.h"
#include "itkStackHDF5ImageIO.h"
#include "itkStackTIFFImageIO.h"
#include "itkVersion.h"

namespace itk
{
StackImageIOFactory::StackImageIOFactory()
{
  const char * const base = "itkImageIOBase";
  this->RegisterOverride(
    base, "itkStackTIFFImageIO", "TIFF of microscopy", true, CreateObjectFunction<StackTIFFImageIO>::New());
  this->RegisterOverride(
    base, "itkStackHDF5ImageIO", "HDF5 of ilastik and PlantSeg", true, CreateObjectFunction<StackHDF5ImageIO>::New());
  this->RegisterOverride(base, "itkInrImageIO", "Inrimage", true, CreateObjectFunction<InrImageIO>::New());
}

const char *
StackImageIOFactory::GetITKSourceVersion() const
{
  return ITK_SOURCE_VERSION;
}

const char *
StackImageIOFactory::GetDescription() const
{
  return "Readers of 3-D images of microscopy";
}

void
StackImageIOFactory::RegisterOneFactory()
{
  static const bool isRegistered = ObjectFactoryBase::RegisterFactory(
    StackImageIOFactory::New(), ObjectFactoryEnums::InsertionPosition::INSERT_AT_FRONT);
  static_cast<void>(isRegistered);
}
} // namespace itk
