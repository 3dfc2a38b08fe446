/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkSyntheticNucleiImageFilter_h
#define itkSyntheticNucleiImageFilter_h

#include "itkImage.h"
#include "itkImageToImageFilter.h"
#include "itkPointSet.h"

#include <cstdint>
#include <map>

namespace itk
{
/** \class SyntheticNucleiImageFilter
 * \brief Makes images like those of stained nuclei from the label image of a tissue.
 *
 * In each cell is a nucleus, a ball within the cell, of a random size, brightness, and place off the cell's centre. The
 * image is blurred as by a microscope, then photons are counted (Poisson noise) and read (Gaussian noise, of the same
 * variance at a nucleus), each by ITK's filter.
 *
 * Input: a label image; output: an image of unsigned shorts, and GetNuclei(): the nuclei's centroids in physical space,
 * the label and the radius as their data, ascending by label. The same parameters give the same image for any number
 * of threads.
 *
 * \ingroup TissueTessellation
 */
template <typename TLabelImage>
class ITK_TEMPLATE_EXPORT SyntheticNucleiImageFilter : public ImageToImageFilter<TLabelImage, Image<std::uint16_t, 3>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SyntheticNucleiImageFilter);

  using Self = SyntheticNucleiImageFilter;
  using LabelImageType = TLabelImage;
  using LabelType = typename TLabelImage::PixelType;
  using OutputImageType = Image<std::uint16_t, 3>;
  using Superclass = ImageToImageFilter<LabelImageType, OutputImageType>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  /** The label and the radius of a nucleus. */
  using NucleusDataType = Vector<double, 2>;
  using NucleiType = PointSet<NucleusDataType, 3, DefaultStaticMeshTraits<NucleusDataType, 3, 3, double>>;

  static_assert(TLabelImage::ImageDimension == 3, "A tissue has three dimensions.");

  itkNewMacro(Self);
  itkTypeMacro(SyntheticNucleiImageFilter, ImageToImageFilter);

  /** The label of the exterior, which has no nucleus. The default is 0. */
  itkSetMacro(ExteriorLabel, LabelType);
  itkGetConstMacro(ExteriorLabel, LabelType);

  /** The mean radius of a nucleus over that of a ball of its cell's volume, above 0 and below 1. Each nucleus has 0.8
   * to 1.2 times as much. The default is 0.5. */
  itkSetMacro(RadiusShare, double);
  itkGetConstMacro(RadiusShare, double);

  /** The farthest that a nucleus is off its cell's centre, in radii of a ball of the cell's volume. The default is
   * 0.25.
   */
  itkSetMacro(Decentering, double);
  itkGetConstMacro(Decentering, double);

  /** The standard deviation of the blur, in voxels along each axis; 0 stands for no blur. The default is 1. */
  itkSetMacro(Blur, double);
  itkGetConstMacro(Blur, double);

  /** The signal of a nucleus of mean brightness over the deviation of the noise there, above 0 and at most 100. The
   * default is 5. */
  itkSetMacro(SignalToNoise, double);
  itkGetConstMacro(SignalToNoise, double);

  /** The seed of the random numbers: each gives other nuclei and other noise. The default is 0. */
  itkSetMacro(Seed, std::uint32_t);
  itkGetConstMacro(Seed, std::uint32_t);

  /** The centroids of the nuclei, with their labels and radii as data. They are valid after the update. */
  const NucleiType *
  GetNuclei() const
  {
    return m_Nuclei;
  }

protected:
  SyntheticNucleiImageFilter();
  ~SyntheticNucleiImageFilter() override = default;

  void
  GenerateInputRequestedRegion() override;

  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  using RealImageType = Image<float, 3>;
  using RealImagePointer = typename RealImageType::Pointer;

  struct Nucleus
  {
    Point<double, 3> cellCenter;
    double           cellVolume = 0.0;
    Point<double, 3> center;
    double           radius = 0.0;
    double           brightness = 0.0;
    /** The centroid and the number of the painted voxels, each by its share that is in the nucleus. */
    Point<double, 3> centroid;
    double           weight = 0.0;
  };
  /** The nuclei by the labels of their cells. */
  using Nuclei = std::map<LabelType, Nucleus>;

  /** Draws a place, a radius and a brightness for the nucleus of each cell. */
  Nuclei
  PlaceNuclei() const;

  /** Paints the nuclei as they would be seen without blur and noise, where 1 is the mean brightness. */
  RealImagePointer
  PaintNuclei(Nuclei & nuclei) const;

  /** Blurs the image, turns brightness to photons, and adds the noise of counting and of reading them. */
  RealImagePointer
  BlurAndCount(RealImagePointer image) const;

  LabelType                    m_ExteriorLabel = 0;
  double                       m_RadiusShare = 0.5;
  double                       m_Decentering = 0.25;
  double                       m_Blur = 1.0;
  double                       m_SignalToNoise = 5.0;
  std::uint32_t                m_Seed = 0;
  typename NucleiType::Pointer m_Nuclei;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkSyntheticNucleiImageFilter.hxx"
#endif

#endif
