/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkDifferenceOfGaussiansBlobDetectionFilter_h
#define itkDifferenceOfGaussiansBlobDetectionFilter_h

#include "TissueTessellationCore/Points/BlobSelection.h"
#include "itkContinuousIndex.h"
#include "itkImage.h"
#include "itkImageNoiseCalculator.h"
#include "itkImageToImageFilter.h"
#include "itkPointSet.h"
#include "itkProcessObject.h"
#include "itkVector.h"
#include "itkVectorContainer.h"
#include "vnl/vnl_matrix_fixed.h"

#include <array>
#include <vector>

namespace itk
{
class DifferenceOfGaussiansNeighborhood;

/** \class DifferenceOfGaussiansBlobDetectionFilter
 * \brief Finds blobs, such as stained nuclei, as the maxima of an image's scale space.
 *
 * Input: a 3-D scalar image. Output: a PointSet of the blobs' positions in physical space, by falling response; the
 * data of a point are its scale, in physical units, and its response (paper, section 3, after D. Lowe 2004,
 * doi:10.1023/B:VISI.0000029664.99615.94).
 *
 * A level of the scale space is the difference of the image smoothed by Gaussians of two deviations a step apart,
 * over the step's logarithm: -sigma^2 times the Laplacian at their geometric mean, whose maximum over the scales is a
 * ball's radius over sqrt(3). Deviations are physical, so that every axis is smoothed by its own number of voxels. A
 * voxel that exceeds its 80 neighbours in space and scale, of which fewer exist on the border, is a blob. Its position
 * and scale come from the parabola through these. Long things (tubes, ridges, flat walls) are rejected by the ratio of
 * the Hessian's eigenvalues. Of two blobs that overlap the weaker is dropped.
 *
 * Where no threshold is given, a blob's response must be so many times the deviation of what the image's noise makes at
 * its scale (ImageNoiseCalculator, tissue::NoiseResponse) that noise alone has no blobs (tissue::LeastBlobEvidence).
 * Noise that is not independent from voxel to voxel has some; but then the inverse image has blobs as strong
 * (tissue::AreBlobsWeak): those are left that are stronger than all of the inverse, and HasWeakEvidence() is on.
 *
 * The smoothed image of a level makes that of the next, by ITK's recursive Gaussian filter, or by its discrete one
 * where a deviation is below 0.6 voxels. Once a level is smooth along an axis, with a deviation of two voxels, every
 * other voxel is left out there, as in Lowe's pyramid. At most four smoothed images are in memory, beside the one that
 * the smoothing works on. The result is the same for any number of threads.
 *
 * Exceptions: pixels that are not finite, a constant image, a minimum scale below half a voxel (of the finest axis), a
 * maximum scale below the minimum or above the image's shortest side, one scale without the other. An image without
 * blobs gives an empty set.
 *
 * \ingroup TissueTessellation
 */
template <typename TInputImage>
class ITK_TEMPLATE_EXPORT DifferenceOfGaussiansBlobDetectionFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DifferenceOfGaussiansBlobDetectionFilter);

  using Self = DifferenceOfGaussiansBlobDetectionFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using InputImageType = TInputImage;
  /** The scale and the response of a blob. */
  using BlobDataType = Vector<double, 2>;
  using OutputType = PointSet<BlobDataType, 3, DefaultStaticMeshTraits<BlobDataType, 3, 3, double>>;

  using BlobDataContainer = VectorContainer<IdentifierType, double>;

  static_assert(TInputImage::ImageDimension == 3, "A tissue has three dimensions.");

  itkNewMacro(Self);
  itkTypeMacro(DifferenceOfGaussiansBlobDetectionFilter, ProcessObject);

  using Superclass::SetInput;
  void
  SetInput(const InputImageType * image);
  const InputImageType *
  GetInput() const;

  OutputType *
  GetOutput();
  const OutputType *
  GetOutput() const;

  /** The scales of the smallest and the largest blobs, which are standard deviations in physical units. Where both are
   * 0, the default, they are found from the maxima at all scales, from a voxel, or half a voxel of an image without
   * noise, to a sixth of the image's shortest side (tissue::ChooseBlobScales), and so are blobs of a second size
   * (tissue::FindBlobsOfOtherSizes). */
  itkSetMacro(MinimumScale, double);
  itkGetConstMacro(MinimumScale, double);
  itkSetMacro(MaximumScale, double);
  itkGetConstMacro(MaximumScale, double);

  /** The number of levels for each doubling of the scale, at least 1. The default is 4. */
  itkSetClampMacro(StepsPerOctave, unsigned int, 1, 64);
  itkGetConstMacro(StepsPerOctave, unsigned int);

  /** Tells whether blobs are darker than their surroundings instead of brighter. The default is off. */
  itkSetMacro(DarkBlobs, bool);
  itkGetConstMacro(DarkBlobs, bool);
  itkBooleanMacro(DarkBlobs);

  /** The least response of a blob, in units of the image. Where it is not positive, RelativeThreshold rules. The
   * default is 0. */
  itkSetMacro(Threshold, double);
  itkGetConstMacro(Threshold, double);

  /** The least response of a blob relative to the greatest, below 1. Where it is not positive, the threshold is found
   * from the noise and from the responses of all maxima (tissue::ChooseBlobThreshold). The default is 0. */
  itkSetMacro(RelativeThreshold, double);
  itkGetConstMacro(RelativeThreshold, double);

  /** The greatest share of the smaller of two balls that they may have in common, 0 .. 1, where 1 keeps all blobs. The
   * default is 0.5. */
  itkSetClampMacro(MaximumOverlap, double, 0.0, 1.0);
  itkGetConstMacro(MaximumOverlap, double);

  /** The greatest ratio of two eigenvalues of the Hessian at a blob; 0 keeps all blobs. The default is 10. */
  itkSetMacro(MaximumHessianRatio, double);
  itkGetConstMacro(MaximumHessianRatio, double);

  /** Blobs nearer than this to the image's border, in physical units, are left out. The default is 0. */
  itkSetMacro(BorderMargin, double);
  itkGetConstMacro(BorderMargin, double);

  /** The threshold of the response and the range of the scales that were used. They are valid after the update. */
  itkGetConstMacro(UsedThreshold, double);
  itkGetConstMacro(UsedMinimumScale, double);
  itkGetConstMacro(UsedMaximumScale, double);

  /** The standard deviation of the image's noise, as estimated, in units of the image. It is valid after the update. */
  itkGetConstMacro(Noise, double);

  /** Tells whether no threshold was given and the inverse image has blobs as strong, so that these may be noise. It is
   * valid after the update. */
  itkGetConstMacro(HasWeakEvidence, bool);

  /** The scale and response of every blob, a copy of the output's point data as one flat array, which is valid after
   * the update. In Python it becomes a NumPy array:
   *
   *     points = itk.array_from_vector_container(filter.GetOutput().GetPoints())
   *     scales, responses = itk.array_from_vector_container(filter.GetBlobData()).reshape(-1, 2).T */
  typename BlobDataContainer::Pointer
  GetBlobData() const;

  using Superclass::MakeOutput;
  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  DifferenceOfGaussiansBlobDetectionFilter();
  ~DifferenceOfGaussiansBlobDetectionFilter() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  /** Does nothing, as a set of points takes over no information of the image. */
  void
  GenerateOutputInformation() override
  {}

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  using RealImageType = Image<float, 3>;
  using RealImagePointer = typename RealImageType::Pointer;
  /** Four smoothed images in a row, whose differences are three levels of the scale space. */
  using Window = std::array<RealImagePointer, 4>;
  using IndexType = typename RealImageType::IndexType;

  /** What was found in the scale space, in an order that depends on the threads. */
  struct Maxima
  {
    std::vector<tissue::Blob> blobs;
    /** Those of the inverse image that noise does not have, where no threshold is given. */
    std::vector<tissue::Blob> inverse;
  };
  /** A level of the scale space, with what is the same for all of its voxels. */
  struct Level
  {
    double scale;
    double step;
    /** Of noise of deviation 1. */
    double noiseResponse;
  };

  /** Copies the input to an image in which blobs are bright. */
  RealImagePointer
  ConvertInput() const;

  /** Estimates the noise, and whether there is any. */
  void
  EstimateNoise(const RealImageType * image);

  RealImagePointer
  Smooth(RealImagePointer image, double deviation);

  RealImagePointer
  Apply(ImageToImageFilter<RealImageType, RealImageType> * filter, const RealImageType * image) const;

  /** Leaves out every other voxel along the axes where images of this deviation are smooth. Returns false where there
   * is no such axis. */
  bool
  HalveWhereSmooth(Window & window, double deviation) const;
  static RealImagePointer
  Subsample(const RealImageType * image, const std::array<int, 3> & factors);

  bool
  HasScales() const
  {
    return m_MinimumScale > 0.0;
  }
  bool
  HasThreshold() const
  {
    return m_Threshold > 0.0 || m_RelativeThreshold > 0.0;
  }
  /** The scales to look at. */
  tissue::BlobScaleRange
  GetSearchedScales() const;

  /** Finds all maxima of the scale space that are blobs. */
  Maxima
  FindMaxima(RealImagePointer image, const tissue::BlobScaleRange & scales);

  /** Appends the maxima of the middle level. */
  void
  CollectMaxima(const Window & window, double scale, double step, Maxima & maxima);

  /** Appends the blob of a voxel, if it is one. */
  void
  AppendBlob(const RealImageType * image, const DifferenceOfGaussiansNeighborhood & difference, const IndexType & index,
             const Level & level, std::vector<tissue::Blob> & blobs) const;

  /** Fits the parabola to a maximum and makes a blob of it. Returns false where it is not one. */
  bool
  FitBlob(const RealImageType * image, const DifferenceOfGaussiansNeighborhood & difference, const IndexType & index,
          const Level & level, tissue::Blob & blob) const;

  /** The deviation of the response of noise where a blob is. */
  double
  NoiseAt(const tissue::Blob & blob, const Level & level) const;

  bool
  IsRound(const vnl_matrix_fixed<double, 4, 4> & hessian, const typename RealImageType::SpacingType & spacing) const;
  bool
  IsWithinMargin(const Point<double, 3> & position) const;

  /** Tells whether noise does not have such a blob. */
  bool
  IsCertain(const tissue::Blob & blob) const;

  /** The given scales, or those that the maxima tell. */
  tissue::BlobScaleRange
  ChooseScales(const std::vector<tissue::Blob> & maxima) const;

  /** Drops maxima of other scales and those that overlap stronger ones. The others come by falling response. */
  std::vector<tissue::Blob>
  TakeScales(std::vector<tissue::Blob> maxima, const tissue::BlobScaleRange & scales) const;

  /** The threshold of blobs, which noise does not have and which are in order, as all maxima tell it. */
  double
  ChooseThreshold(const std::vector<tissue::Blob> & blobs, const std::vector<tissue::Blob> & maxima) const;

  /** Adds the blobs of a second size, which come from all maxima. */
  void
  AddOtherSizes(const std::vector<tissue::Blob> & maxima, std::vector<tissue::Blob> & blobs);

  /** Leaves blobs that are stronger than those of the inverse image, where most are not. */
  void
  CompareWithInverse(const std::vector<tissue::Blob> & inverse, std::vector<tissue::Blob> & blobs);

  void
  SetBlobs(const std::vector<tissue::Blob> & blobs);

  double       m_MinimumScale = 0.0;
  double       m_MaximumScale = 0.0;
  unsigned int m_StepsPerOctave = 4;
  bool         m_DarkBlobs = false;
  double       m_Threshold = 0.0;
  double       m_RelativeThreshold = 0.0;
  double       m_MaximumOverlap = 0.5;
  double       m_MaximumHessianRatio = 10.0;
  double       m_BorderMargin = 0.0;
  double       m_UsedThreshold = 0.0;
  double       m_UsedMinimumScale = 0.0;
  double       m_UsedMaximumScale = 0.0;
  double       m_Noise = 0.0;
  bool         m_IsNoisy = false;
  bool         m_HasWeakEvidence = false;

  typename ImageNoiseCalculator<RealImageType>::Pointer m_NoiseCalculator;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkDifferenceOfGaussiansBlobDetectionFilter.hxx"
#endif

#endif
