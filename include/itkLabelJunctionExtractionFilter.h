/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkLabelJunctionExtractionFilter_h
#define itkLabelJunctionExtractionFilter_h

#include "itkImage.h"
#include "itkProcessObject.h"
#include "itkTissueJunctions.h"

#include <array>
#include <map>
#include <memory>
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
 *
 * Cells that share a voxel face have a wall. A window of 2x2x2 voxels passes over the image and one voxel beyond on all
 * sides: each three of the labels it sees are a triple line, each four a junction (section 3.4 of the paper).
 *
 * Exterior: the outside of the image always; the exterior label, given or found by ExteriorLabelImageCalculator; and
 * label 0, unless it is asked to be a cell. Several such labels are one exterior. A void of it that the tissue
 * encloses, with four or more cells around it, is told from it (EnclosedVoidImageFilter): it is one of the voids of the
 * output. An image that has voids is read twice, and needs 5 bytes a voxel then.
 *
 * The image is split along its last axis among the threads and streamed row by row, as runs of equal labels: time is
 * that of reading the voxels once and of the runs, memory that of two planes of runs a thread, of the output, and of
 * the blocks of four and more labels. The output is the same for any number of threads.
 *
 * Errors (ExceptionObject): an exterior label set that the image does not have, fewer than four cells, a label above
 * the range of 64 bits signed.
 *
 * G. Cerutti, S. Ribes, C. Galvan-Ampudia, T. Vernoux, C. Godin: 3-D tessellation of plant tissue. A dual optimization
 * approach to cell-level meristem reconstruction from microscopy images. 3DV 2015.
 *
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

  OutputType *
  GetOutput();
  const OutputType *
  GetOutput() const;

  /** The label of the exterior of the tissue. To set it turns AutomaticExteriorLabel off. */
  void
  SetExteriorLabel(tissue::Label label);
  itkGetConstMacro(ExteriorLabel, tissue::Label);

  /** Find the exterior label by ExteriorLabelImageCalculator. Default: on. */
  itkSetMacro(AutomaticExteriorLabel, bool);
  itkGetConstMacro(AutomaticExteriorLabel, bool);
  itkBooleanMacro(AutomaticExteriorLabel);

  /** Take label 0 for a cell, if it is not the exterior label. Default: off. */
  itkSetMacro(ZeroIsCell, bool);
  itkGetConstMacro(ZeroIsCell, bool);
  itkBooleanMacro(ZeroIsCell);

  /** Tell enclosed voids from the exterior. Default: on. */
  itkSetMacro(SeparateVoids, bool);
  itkGetConstMacro(SeparateVoids, bool);
  itkBooleanMacro(SeparateVoids);

  /** The label of the output's exterior vertex: the one set or found; else 0, or, if 0 is a cell, a negative label that
   * no cell has. Valid after the update. */
  tissue::Label
  GetUsedExteriorLabel() const;

  using Superclass::MakeOutput;
  ProcessObject::DataObjectPointer
  MakeOutput(ProcessObject::DataObjectPointerArraySizeType index) override;

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

  ScanMap
  ScanImage(const std::array<std::int32_t, 3> & size, const tissue::ExteriorLabels & exterior);

  tissue::JunctionSet
  Gather(const ScanMap & scans, const std::array<std::int32_t, 3> & size,
         const tissue::ExteriorLabels & exterior) const;

  /** Scans the image again with each enclosed void as a label of its own, if there is one. */
  void
  SeparateVoidsOf(tissue::JunctionSet & junctions, const std::array<std::int32_t, 3> & size,
                  tissue::ExteriorLabels exterior);

  /** Feeds the scan with a plane, in its padded coordinates. */
  void
  ScanPlane(IndexValueType plane, tissue::BlockScan & scan) const;

  void
  ScanImageRow(const LabelPixelType * row, SizeValueType size, tissue::BlockScan & scan) const;

  /** Likewise, where the row of `voids` is not 0 with the labels from m_FirstVoidLabel on. */
  void
  ScanImageRow(const LabelPixelType * row, const std::uint32_t * voids, SizeValueType size,
               tissue::BlockScan & scan) const;

  void
  AddRun(LabelPixelType pixel, SizeValueType end, tissue::BlockScan & scan) const;

  /** Throws if the exterior label is absent or there are too few cells. */
  void
  CheckCells(const ScanMap & scans, const tissue::JunctionSet & junctions) const;

  /** From continuous indices to the physical space of the image. */
  void
  TransformToPhysicalSpace(tissue::JunctionSet & junctions) const;

  tissue::Label m_ExteriorLabel = 0;
  bool          m_AutomaticExteriorLabel = true;
  bool          m_ZeroIsCell = false;
  bool          m_SeparateVoids = true;

  /** While the image is scanned with its voids; else null. */
  Image<std::uint32_t, 3>::Pointer m_Voids;
  tissue::Label                    m_FirstVoidLabel = 0;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkLabelJunctionExtractionFilter.hxx"
#endif

#endif
