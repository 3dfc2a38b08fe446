/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkLabelJunctionExtractionFilter_h
#define itkLabelJunctionExtractionFilter_h

#include "itkExteriorLabelSettings.h"
#include "itkProcessObject.h"
#include "itkTissueJunctions.h"
#include "itkTissueLabelVolume.h"
#include "itkTissueVotes.h"

#include <array>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

namespace tissue
{
class BlockScan;
struct ExteriorLabels;
} // namespace tissue

namespace itk
{
/** \class LabelJunctionExtractionFilter
 * \brief Finds the cells of a segmented tissue and where two, three and four of them meet.
 *
 * Input: a three-dimensional image of any integer pixel type, spacing, origin and direction; each label is a cell, ids
 * may have gaps. Output: TissueJunctions, in the physical space of the image (tissue::JunctionSet says what it holds).
 * Second output, if asked for: TissueLabelVolume, the image by the vertices of the junctions, which the walls of
 * JunctionsToCellWallMeshFilter are fitted to.
 *
 * Cells that share a voxel face have a wall. A window of 2x2x2 voxels passes over the image and one voxel beyond on all
 * sides: each three of the labels it sees are a triple line, each four a junction (section 3.4 of the paper).
 *
 * Exterior: the outside of the image always; the exterior labels, given or found by ExteriorLabelImageCalculator; label
 * 0, unless it is asked to be a cell; and labels that are dropped. Several such labels are one exterior, and so are its
 * voids in the tissue. Where suspects are dropped the image is read twice.
 *
 * The image is split along its last axis among the threads and streamed row by row, as runs of equal labels: time is
 * that of reading the voxels once and of the runs, memory that of two planes of runs a thread, of the output, and of
 * the blocks of four and more labels; the label volume takes 4 bytes a voxel. The outputs are the same for any number
 * of threads.
 *
 * Optional second input: the votes on which cells of an estimated tissue meet (SetVotes()), which become those of the
 * output.
 *
 * Errors (ExceptionObject): an exterior label set, or a label to be dropped, that the image does not have; a vote on a
 * cell that it does not have; no cell; a label above the range of 64 bits signed.
 *
 * G. Cerutti, S. Ribes, C. Galvan-Ampudia, T. Vernoux, C. Godin: 3-D tessellation of plant tissue. A dual optimization
 * approach to cell-level meristem reconstruction from microscopy images. 3DV 2015.
 *
 * \sa JunctionsToCellWallMeshFilter
 * \sa ExteriorLabelImageCalculator
 * \sa LabelGapClosingImageFilter
 * \ingroup TissueTessellation
 */
template <typename TLabelImage>
class ITK_TEMPLATE_EXPORT LabelJunctionExtractionFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LabelJunctionExtractionFilter);

  using Self = LabelJunctionExtractionFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using LabelImageType = TLabelImage;
  using LabelPixelType = typename LabelImageType::PixelType;
  using OutputType = TissueJunctions;

  itkNewMacro(Self);
  itkTypeMacro(LabelJunctionExtractionFilter, ProcessObject);

  using Superclass::SetInput;
  void
  SetInput(const LabelImageType * image);
  const LabelImageType *
  GetInput() const;

  /** The votes that PointSetToTissueLabelImageFilter makes with the image. Default: none. */
  itkSetInputMacro(Votes, TissueVotes);
  itkGetInputMacro(Votes, TissueVotes);

  OutputType *
  GetOutput();
  const OutputType *
  GetOutput() const;

  /** The second output, by name ("LabelVolume"), as it is beside the one that the filter is for; empty unless
   * GenerateLabelVolume is on. */
  TissueLabelVolume *
  GetLabelVolume();
  const TissueLabelVolume *
  GetLabelVolume() const;

  /** Make the second output. Default: off. */
  itkSetMacro(GenerateLabelVolume, bool);
  itkGetConstMacro(GenerateLabelVolume, bool);
  itkBooleanMacro(GenerateLabelVolume);

  /** ExteriorLabel, AutomaticExteriorLabel, ZeroIsCell, DroppedLabels, DropSuspects: see itkExteriorLabelSettings.h. */
  itkExteriorLabelMacro();

#ifndef ITK_WRAPPING_PARSER
  /** All of these at once, for C++. */
  void
  SetExterior(const ExteriorLabelSettings & settings);

  /** The labels that were dropped, those asked for and the suspects, ascending. Valid after the update. */
  const std::vector<tissue::Label> &
  GetUsedDroppedLabels() const
  {
    return m_UsedDroppedLabels;
  }
#endif

  /** The label of the output's exterior vertex: the one set or found; else 0, or, if 0 is a cell, a negative label that
   * no cell has. Valid after the update. */
  tissue::Label
  GetUsedExteriorLabel() const;

  using Superclass::MakeOutput;
  ProcessObject::DataObjectPointer
  MakeOutput(ProcessObject::DataObjectPointerArraySizeType index) override;
  ProcessObject::DataObjectPointer
  MakeOutput(const ProcessObject::DataObjectIdentifierType & name) override;

protected:
  LabelJunctionExtractionFilter();
  ~LabelJunctionExtractionFilter() override = default;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** The scans by their first planes. */
  using ScanMap = std::map<IndexValueType, std::shared_ptr<tissue::BlockScan>>;

  /** Those set or found. */
  tissue::ExteriorLabels
  FindExteriorLabels() const;

  ScanMap
  ScanImage(const std::array<std::int32_t, 3> & size, const tissue::ExteriorLabels & exterior);

  tissue::JunctionSet
  Gather(const ScanMap & scans, const std::array<std::int32_t, 3> & size,
         const tissue::ExteriorLabels & exterior) const;

  /** Feeds the scan with a plane, in its padded coordinates. */
  void
  ScanPlane(IndexValueType plane, tissue::BlockScan & scan) const;

  void
  ScanImageRow(const LabelPixelType * row, SizeValueType size, tissue::BlockScan & scan) const;

  void
  AddRun(LabelPixelType pixel, SizeValueType end, tissue::BlockScan & scan) const;

  /** Throws if a label that was named is absent, or there is no cell. */
  void
  CheckCells(const ScanMap & scans, const tissue::JunctionSet & junctions) const;

  tissue::JunctionSet
  Extract(const tissue::ExteriorLabels & exterior);

  /** From continuous indices to the physical space of the image. */
  void
  TransformToPhysicalSpace(tissue::JunctionSet & junctions) const;

  tissue::ImageGrid
  DescribeGrid() const;

  /** The vertices of the cells by their labels; the exterior is not among them. */
  static std::unordered_map<tissue::Label, tissue::VertexId>
  NumberLabels(const tissue::JunctionSet & junctions);

  /** The votes by vertices of the junctions. */
  std::vector<tissue::JunctionVote>
  NumberVotes(const tissue::JunctionSet & junctions) const;

  /** Each voxel by its vertex in the junctions. A label that is no cell's is the exterior's. */
  std::shared_ptr<const tissue::LabelVolume>
  MakeLabelVolume(const tissue::JunctionSet & junctions) const;

  void
  NumberVoxels(const tissue::JunctionSet & junctions, tissue::LabelVolume & volume) const;

  ExteriorLabelSettings      m_Exterior;
  std::vector<tissue::Label> m_UsedDroppedLabels;
  bool                       m_GenerateLabelVolume = false;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkLabelJunctionExtractionFilter.hxx"
#endif

#endif
