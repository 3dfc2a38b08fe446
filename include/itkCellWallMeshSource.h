/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCellWallMeshSource_h
#define itkCellWallMeshSource_h

#include "TissueTessellationExport.h"
#include "itkCellWallMesh.h"
#include "itkProcessObject.h"

#include <memory>
#include <string>

namespace tissue
{
struct ReconstructionParameters;
}

namespace itk
{
/** \class CellWallMeshSource
 * \brief Base of the filters that make a CellWallMesh: holds the parameters of the reconstruction.
 *
 * The preset sets all parameters at once; single ones can be changed after it. The default takes the adjacency complex
 * from the label image and fits the walls to it. PAPER is the method of the paper to the letter: a complex of the
 * cells' centres. Finer parameters are in tissue::ReconstructionParameters, for C++.
 *
 * \ingroup TissueTessellation
 */
class TissueTessellation_EXPORT CellWallMeshSource : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CellWallMeshSource);

  using Self = CellWallMeshSource;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(CellWallMeshSource, ProcessObject);

  using SeedType = SizeValueType;

  /** Sets every parameter to the preset for label images (the state of a new filter). */
  void
  UseDefaultPreset();

  /** Sets every parameter to those of the paper. */
  void
  UsePaperPreset();

  /** Seed of the paper preset's annealing; default 1. */
  void
  SetSeed(SeedType seed);
  SeedType
  GetSeed() const;

  /** l_max: surface triangles with a longer edge are removed in the paper preset's clean-up; in the image's units.
   * Default 0: from the distances of neighbouring cells. */
  void
  SetMaximumEdgeLength(double length);
  double
  GetMaximumEdgeLength() const;

  /** Temperature cycles of the paper preset's annealing, 0 .. 1000; default 5. */
  void
  SetNumberOfCycles(int cycles);
  int
  GetNumberOfCycles() const;

  /** Triangles of the fitted walls a cell, each counted once, 40 .. 10000; default 150. */
  void
  SetTrianglesPerCell(double number);
  double
  GetTrianglesPerCell() const;

  /** Times that the triangles of the star-shaped walls are split in four, 0 .. 3; default 1. At 0, walls that are
   * fitted to an image are the fitted stars. */
  void
  SetRefinement(int levels);
  int
  GetRefinement() const;

  /** Iterations of the smoothing of walls that are not fitted, 0 .. 10000; default 10. */
  void
  SetSmoothingIterations(int iterations);
  int
  GetSmoothingIterations() const;

#ifndef ITK_WRAPPING_PARSER
  /** All parameters, for C++. */
  void
  SetParameters(const tissue::ReconstructionParameters & parameters);

  const tissue::ReconstructionParameters &
  GetParameters() const
  {
    return *m_Parameters;
  }
#endif

  /** What the filter is doing, in a few words, "Fitting the walls": to be asked for with its progress. */
  itkGetStringMacro(Phase);

  CellWallMesh *
  GetOutput();

  const CellWallMesh *
  GetOutput() const;

  using Superclass::MakeOutput;
  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  CellWallMeshSource();
  ~CellWallMeshSource() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  /** Names the phase, and tells those who observe the progress. */
  void
  EnterPhase(const std::string & phase);

private:
  /** Replaces the parameters by a changed copy. */
  template <typename TChange>
  void
  Change(const TChange & change);

  std::shared_ptr<const tissue::ReconstructionParameters> m_Parameters;
  std::string                                             m_Phase;
};
} // namespace itk

#endif
