/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkExteriorLabelImageCalculator_h
#define itkExteriorLabelImageCalculator_h

#include "TissueTessellationCore/Common/Types.h"
#include "itkObject.h"
#include "itkObjectFactory.h"

#include <array>
#include <map>
#include <vector>

namespace itk
{
/** \class ExteriorLabelImageCalculator
 * \brief Guesses which labels of a segmented image stand for the exterior of the tissue.
 *
 * Label 0 is taken for background in any case. The question is whether another label is the exterior, as 1 is in the
 * images of MARS and DRACO-STEM. Lines of sight enter the image from its border, along the axes, at no more than 32 x
 * 32 points of each of its six sides, pass through label 0, and end at the first other label. A label is the exterior
 * if it is seen by an eighth of the lines or more (one side of a cube is a sixth of its border), and
 * - four times as often as any other label, from more than two sides or with twice the median volume of the others; a
 *   crop from within a tissue, where each cell has its small share, has no such label, and a cell that the border cuts
 *   is seen from few sides; or
 * - from five sides or more, and has eight times the median volume of the other labels: a background in several parts,
 *   of which each is an exterior label.
 *
 * Where most lines start in label 0, that is the background, and several cells are seen in it. Another label is the
 * exterior, within a padding of 0, if it is seen by at least 95 % of the lines that see anything, and either is as flat
 * as a padded image on three quarters of these lines, with two other labels at least, or has eight times the median
 * volume of four other labels at least. Otherwise it is a cell around others, or a single one.
 *
 * Pixels: any integer type. The buffer must hold the largest possible region.
 *
 * \ingroup TissueTessellation
 */
template <typename TLabelImage>
class ITK_TEMPLATE_EXPORT ExteriorLabelImageCalculator : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ExteriorLabelImageCalculator);

  using Self = ExteriorLabelImageCalculator;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using LabelImageType = TLabelImage;

  itkNewMacro(Self);
  itkTypeMacro(ExteriorLabelImageCalculator, Object);

  itkSetConstObjectMacro(Image, LabelImageType);

  /** Tells whether label 0 is a cell like others, which ends a line of sight and is not the exterior. The default is
   * off.
   */
  itkSetMacro(ZeroIsCell, bool);
  itkGetConstMacro(ZeroIsCell, bool);
  itkBooleanMacro(ZeroIsCell);

  void
  Compute();

  /** Tells whether a label other than 0 was found to be the exterior. */
  bool
  GetHasExteriorLabel() const
  {
    return !m_ExteriorLabels.empty();
  }
  /** The label that was found to be the exterior, of several the one seen most often; 0 if there is none. */
  tissue::Label
  GetExteriorLabel() const
  {
    return m_ExteriorLabels.empty() ? tissue::Label{ 0 } : m_ExteriorLabels.front();
  }
  SizeValueType
  GetNumberOfExteriorLabels() const
  {
    return m_ExteriorLabels.size();
  }
#ifndef ITK_WRAPPING_PARSER
  /** All labels that were found to be the exterior, those first that are seen most often, for C++. */
  const std::vector<tissue::Label> &
  GetExteriorLabels() const
  {
    return m_ExteriorLabels;
  }
#endif

protected:
  ExteriorLabelImageCalculator() = default;
  ~ExteriorLabelImageCalculator() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** How a label is seen. */
  struct LabelSights
  {
    SizeValueType number = 0;
    /** From each of the image's sides. */
    std::array<SizeValueType, 6> numberFromSide{};
    /** From each side by the number of pixels of label 0 before it. */
    std::array<std::map<SizeValueType, SizeValueType>, 6> numberAtDepth;
  };

  struct Sights
  {
    std::map<tissue::Label, LabelSights> ofLabel;
    SizeValueType                        numberOfLines = 0;
    SizeValueType                        numberOfLinesFromZero = 0;
  };

  using VolumeMap = std::map<tissue::Label, SizeValueType>;

  /** Follows a line of sight of the given number of pixels, from a side. */
  void
  Look(const typename LabelImageType::PixelType * pixel, OffsetValueType stride, SizeValueType length,
       unsigned int side, Sights & sights) const;

  /** Follows the lines from both sides along an axis. */
  void
  LookAlong(unsigned int axis, Sights & sights) const;

  /** The voxels of each label that may be a cell's. */
  VolumeMap
  CountVoxels() const;

  /** The label seen most often, where it is the exterior within a padding of 0. */
  void
  JudgePadding(const Sights & sights);

  /** Whether a label that is seen often is the exterior. */
  bool
  IsExterior(tissue::Label label, const Sights & sights, const VolumeMap & volumes) const;

  typename LabelImageType::ConstPointer m_Image;
  bool                                  m_ZeroIsCell = false;
  std::vector<tissue::Label>            m_ExteriorLabels;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkExteriorLabelImageCalculator.hxx"
#endif

#endif
