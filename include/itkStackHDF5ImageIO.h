/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkStackHDF5ImageIO_h
#define itkStackHDF5ImageIO_h

#include "itkStackImageIOBase.h"

#include <memory>
#include <utility>

namespace tissue
{
struct HDF5Dataset;
}

namespace itk
{
/** \class StackHDF5ImageIO
 * \brief Reads a data set of three dimensions from a file of HDF5, as ilastik and PlantSeg write them.
 *
 * The name of the file may be followed by that of a data set, "tissue.h5:/label". Without it the file must have one
 * data set alone of three dimensions, or one of integers among them; else the exception names them all. The axes are
 * those of the attribute axistags (ilastik), or z, y, x; channels and frames are chosen, see StackImageIOBase. The size
 * of a voxel is that of the attribute element_size_um (z, y, x in micrometres, PlantSeg), or the resolution in
 * axistags. Numbers: integers of 8 to 64 bits and floats. Files of ITK itself and of MINC, which are HDF5 as well, are
 * not taken.
 *
 * \ingroup TissueTessellation
 */
class TissueTessellation_EXPORT StackHDF5ImageIO : public StackImageIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(StackHDF5ImageIO);

  using Self = StackHDF5ImageIO;
  using Superclass = StackImageIOBase;
  using Pointer = SmartPointer<Self>;

  itkNewMacro(Self);
  itkTypeMacro(StackHDF5ImageIO, StackImageIOBase);

  /** Whether, of several data sets, the only one of integers is taken: for labels. The default is on. */
  itkSetMacro(PrefersIntegers, bool);
  itkGetConstMacro(PrefersIntegers, bool);
  itkBooleanMacro(PrefersIntegers);

  /** The name of the file and that of the data set, which may be empty. */
  static std::pair<std::string, std::string>
  SplitPath(const std::string & path);

  bool
  CanReadFile(const char * path) override;
  void
  ReadImageInformation() override;
  void
  Read(void * buffer) override;

protected:
  StackHDF5ImageIO();
  ~StackHDF5ImageIO() override;

private:
  bool                                 m_PrefersIntegers = true;
  std::unique_ptr<tissue::HDF5Dataset> m_Dataset;
};
} // namespace itk

#endif
