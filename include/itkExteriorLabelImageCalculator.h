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

#include <map>

namespace itk
{
/** \class ExteriorLabelImageCalculator
 * \brief Guesses which label of a segmented image stands for the exterior of the tissue.
 *
 * Label 0 is taken for background in any case. The question is whether another label is the exterior, as 1 is in the
 * images of MARS and DRACO-STEM. Lines of sight enter the image from its border, along the axes, at no more than 32 x
 * 32 points of each of its six sides, pass through label 0, and end at the first other label. The label seen most often
 * is the exterior if
 * - it is seen by an eighth of the lines or more (one side of a cube is a sixth of its border), and four times as often
 *   as any other label; a crop from within a tissue, where each cell has its small share, has no such label; or
 * - where most lines start in label 0, it is seen by at least 95 % of the lines that see anything: a padding of 0
 *   around an image that has an exterior label. A tissue in a background of 0 shows several of its cells.
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
  itkGetConstMacro(HasExteriorLabel, bool);
  /** The label that was found to be the exterior; 0 if there is none. */
  itkGetConstMacro(ExteriorLabel, tissue::Label);

protected:
  ExteriorLabelImageCalculator() = default;
  ~ExteriorLabelImageCalculator() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** The numbers of lines of sight: by the label that they met, all, and those that began in label 0. */
  struct Sights
  {
    std::map<tissue::Label, SizeValueType> numberByLabel;
    SizeValueType                          numberOfLines = 0;
    SizeValueType                          numberOfLinesFromZero = 0;
  };

  /** Follows a line of sight of the given number of pixels. */
  void
  Look(const typename LabelImageType::PixelType * pixel, OffsetValueType stride, SizeValueType length,
       Sights & sights) const;

  /** Follows the lines from both sides along an axis. */
  void
  LookAlong(unsigned int axis, Sights & sights) const;

  typename LabelImageType::ConstPointer m_Image;
  bool                                  m_ZeroIsCell = false;
  bool                                  m_HasExteriorLabel = false;
  tissue::Label                         m_ExteriorLabel = 0;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkExteriorLabelImageCalculator.hxx"
#endif

#endif
