/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkDifferenceOfGaussiansBlobDetectionFilter_hxx
#define itkDifferenceOfGaussiansBlobDetectionFilter_hxx

#include "itkDifferenceOfGaussiansBlobDetectionFilter.h"

#include "TissueTessellationCore/Points/BlobNoise.h"
#include "itkContinuousIndex.h"
#include "itkDifferenceOfGaussiansNeighborhood.h"
#include "itkGaussianOperator.h"
#include "itkImageRegionConstIterator.h"
#include "itkImageRegionIterator.h"
#include "itkMath.h"
#include "itkMultiThreaderBase.h"
#include "itkNearestNeighborInterpolateImageFunction.h"
#include "itkNeighborhoodOperatorImageFilter.h"
#include "itkRecursiveGaussianImageFilter.h"
#include "itkResampleImageFilter.h"
#include "itkWorkUnitErrors.h"
#include "vnl/algo/vnl_svd.h"
#include "vnl/algo/vnl_symmetric_eigensystem.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace itk
{
template <typename TInputImage>
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::DifferenceOfGaussiansBlobDetectionFilter()
{
  this->SetNumberOfRequiredInputs(1);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, OutputType::New());
}

template <typename TInputImage>
void
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::SetInput(const InputImageType * image)
{
  this->SetNthInput(0, const_cast<InputImageType *>(image));
}

template <typename TInputImage>
auto
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::GetInput() const -> const InputImageType *
{
  return itkDynamicCastInDebugMode<const InputImageType *>(this->GetPrimaryInput());
}

template <typename TInputImage>
auto
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::GetOutput() -> OutputType *
{
  return itkDynamicCastInDebugMode<OutputType *>(this->GetPrimaryOutput());
}

template <typename TInputImage>
auto
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::GetOutput() const -> const OutputType *
{
  return itkDynamicCastInDebugMode<const OutputType *>(this->GetPrimaryOutput());
}

template <typename TInputImage>
auto
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::GetBlobData() const -> typename BlobDataContainer::Pointer
{
  const auto container = BlobDataContainer::New();
  if (const auto * const data = this->GetOutput()->GetPointData())
  {
    for (auto it = data->Begin(); it != data->End(); ++it)
    {
      container->push_back(it.Value()[0]);
      container->push_back(it.Value()[1]);
    }
  }
  return container;
}

template <typename TInputImage>
ProcessObject::DataObjectPointer
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::MakeOutput(ProcessObject::DataObjectPointerArraySizeType)
{
  return OutputType::New().GetPointer();
}

template <typename TInputImage>
void
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  const bool areGiven = !Math::ExactlyEquals(m_MinimumScale, 0.0) || !Math::ExactlyEquals(m_MaximumScale, 0.0);
  if (areGiven && (!(m_MinimumScale > 0.0) || !(m_MaximumScale >= m_MinimumScale) || !std::isfinite(m_MaximumScale)))
  {
    itkExceptionMacro(<< "The scales are " << m_MinimumScale << " to " << m_MaximumScale
                      << "; the minimum must be above 0 and the maximum at least as large, or both 0.");
  }
  if (!(m_RelativeThreshold < 1.0))
  {
    itkExceptionMacro(<< "The relative threshold is " << m_RelativeThreshold << ", must be below 1.");
  }
}

template <typename TInputImage>
tissue::BlobScaleRange
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::GetSearchedScales() const
{
  const auto * const image = this->GetInput();
  double             finest = image->GetSpacing()[0];
  double             shortest = std::numeric_limits<double>::infinity();
  for (unsigned int i = 0; i < 3; ++i)
  {
    finest = std::min(finest, image->GetSpacing()[i]);
    shortest = std::min(shortest, image->GetSpacing()[i] * image->GetLargestPossibleRegion().GetSize(i));
  }
  if (!this->HasScales())
  {
    // The ball that answers at this scale is already more than half as wide as the shortest side. A single voxel
    // answers at half a voxel, but in noise it tells nothing.
    constexpr double largestShare = 1.0 / 6.0;
    return { m_IsNoisy ? finest : 0.5 * finest, std::max(finest, largestShare * shortest) };
  }
  if (m_MinimumScale < 0.5 * finest)
  {
    itkExceptionMacro(<< "The minimum scale is " << m_MinimumScale
                      << ", must be half a voxel at least: " << 0.5 * finest);
  }
  if (m_MaximumScale > shortest)
  {
    itkExceptionMacro(<< "The maximum scale is " << m_MaximumScale
                      << ", must not exceed the shortest side of the image: " << shortest);
  }
  return { m_MinimumScale, m_MaximumScale };
}

template <typename TInputImage>
auto
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::ConvertInput() const -> RealImagePointer
{
  const InputImageType * input = this->GetInput();
  const auto             image = RealImageType::New();
  image->CopyInformation(input);
  image->SetRegions(input->GetLargestPossibleRegion());
  image->Allocate();
  const float                              sign = m_DarkBlobs ? -1.0f : 1.0f;
  bool                                     isConstant = true;
  ImageRegionIterator<RealImageType>       out(image, image->GetLargestPossibleRegion());
  ImageRegionConstIterator<InputImageType> in(input, input->GetLargestPossibleRegion());
  const auto                               first = in.Get();
  for (; !in.IsAtEnd(); ++in, ++out)
  {
    const auto value = static_cast<float>(in.Get());
    if (!std::isfinite(value))
    {
      itkExceptionMacro(<< "The pixel at " << in.GetIndex() << " is " << value << ", must be finite.");
    }
    isConstant = isConstant && Math::ExactlyEquals(in.Get(), first);
    out.Set(sign * value);
  }
  if (isConstant)
  {
    itkExceptionMacro(<< "All pixels are " << static_cast<double>(first) << ": there is nothing to find.");
  }
  return image;
}

template <typename TInputImage>
void
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::EstimateNoise(const RealImageType * image)
{
  // The second differences of an image without noise may be as much as this of its range.
  constexpr double mostOfSmoothness = 1e-3;
  m_NoiseCalculator = ImageNoiseCalculator<RealImageType>::New();
  m_NoiseCalculator->SetImage(image);
  m_NoiseCalculator->Compute();
  m_Noise = m_NoiseCalculator->GetDeviation();
  const float * const begin = image->GetBufferPointer();
  const auto [least, most] = std::minmax_element(begin, begin + image->GetBufferedRegion().GetNumberOfPixels());
  m_IsNoisy = m_Noise > mostOfSmoothness * (static_cast<double>(*most) - *least);
}

template <typename TInputImage>
auto
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::Smooth(RealImagePointer image, double deviation)
  -> RealImagePointer
{
  // The recursive filter takes the same time for any deviation, but is not accurate for those far below a voxel, and
  // needs four voxels along its axis. Both bounds are in voxels.
  constexpr double        leastRecursive = 0.6;
  constexpr SizeValueType leastSize = 4;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const double voxels = deviation / image->GetSpacing()[axis];
    if (voxels >= leastRecursive && image->GetBufferedRegion().GetSize(axis) >= leastSize)
    {
      const auto recursive = RecursiveGaussianImageFilter<RealImageType, RealImageType>::New();
      recursive->SetDirection(axis);
      recursive->SetSigma(deviation);
      image = this->Apply(recursive.GetPointer(), image);
    }
    else
    {
      GaussianOperator<float, 3> kernel;
      kernel.SetDirection(axis);
      kernel.SetVariance(voxels * voxels);
      kernel.SetMaximumError(0.001);
      kernel.CreateDirectional();
      const auto discrete = NeighborhoodOperatorImageFilter<RealImageType, RealImageType, float>::New();
      discrete->SetOperator(kernel);
      image = this->Apply(discrete.GetPointer(), image);
    }
  }
  return image;
}

template <typename TInputImage>
auto
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::Apply(ImageToImageFilter<RealImageType, RealImageType> * filter,
                                                             const RealImageType * image) const -> RealImagePointer
{
  filter->SetInput(image);
  filter->SetNumberOfWorkUnits(const_cast<Self *>(this)->GetNumberOfWorkUnits());
  filter->Update();
  RealImagePointer output = filter->GetOutput();
  output->DisconnectPipeline();
  return output;
}

template <typename TInputImage>
bool
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::HalveWhereSmooth(Window & window, double deviation) const
{
  // With a deviation of two voxels one of a coarse voxel is left, and half of eight voxels still are enough for the
  // recursive filter.
  constexpr double        enough = 2.0;
  constexpr SizeValueType leastSize = 8;
  const auto              fine = window[3];
  std::array<int, 3>      factors{};
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const bool isSmooth = deviation >= enough * fine->GetSpacing()[axis];
    factors[axis] = isSmooth && fine->GetBufferedRegion().GetSize(axis) >= leastSize ? 2 : 1;
  }
  if (std::all_of(factors.begin(), factors.end(), [](int factor) { return factor == 1; }))
  {
    return false;
  }
  for (RealImagePointer & image : window)
  {
    image = image.IsNotNull() ? Subsample(image, factors) : nullptr;
  }
  return true;
}

template <typename TInputImage>
auto
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::Subsample(const RealImageType *      image,
                                                                 const std::array<int, 3> & factors) -> RealImagePointer
{
  const auto                          region = image->GetBufferedRegion();
  typename RealImageType::SizeType    size;
  typename RealImageType::SpacingType spacing;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    size[axis] = (region.GetSize(axis) + factors[axis] - 1) / factors[axis];
    spacing[axis] = image->GetSpacing()[axis] * factors[axis];
  }
  typename RealImageType::PointType origin;
  image->TransformIndexToPhysicalPoint(region.GetIndex(), origin);
  // Nearest voxels are the very ones that are meant. ShrinkImageFilter would place them half a voxel off at even
  // factors.
  const auto sampling = ResampleImageFilter<RealImageType, RealImageType>::New();
  sampling->SetInput(image);
  sampling->SetInterpolator(NearestNeighborInterpolateImageFunction<RealImageType>::New());
  sampling->SetSize(size);
  sampling->SetOutputSpacing(spacing);
  sampling->SetOutputOrigin(origin);
  sampling->SetOutputDirection(image->GetDirection());
  sampling->Update();
  const RealImagePointer coarse = sampling->GetOutput();
  coarse->DisconnectPipeline();
  return coarse;
}

template <typename TInputImage>
void
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::GenerateData()
{
  const RealImagePointer image = this->ConvertInput();
  this->EstimateNoise(image);
  const Maxima              maxima = this->FindMaxima(image, this->GetSearchedScales());
  std::vector<tissue::Blob> certain;
  const auto isCertain = [this](const tissue::Blob & blob) { return this->HasThreshold() || this->IsCertain(blob); };
  std::copy_if(maxima.blobs.begin(), maxima.blobs.end(), std::back_inserter(certain), isCertain);

  const tissue::BlobScaleRange scales = this->ChooseScales(certain);
  std::vector<tissue::Blob>    blobs = this->TakeScales(certain, scales);
  m_UsedMinimumScale = scales.minimum;
  m_UsedMaximumScale = scales.maximum;
  m_UsedThreshold = this->ChooseThreshold(blobs, maxima.blobs);
  const auto isWeak = [this](const tissue::Blob & blob) { return blob.response < m_UsedThreshold; };
  blobs.erase(std::find_if(blobs.begin(), blobs.end(), isWeak), blobs.end());
  if (!this->HasScales())
  {
    this->AddOtherSizes(certain, blobs);
  }
  if (!this->HasThreshold())
  {
    blobs = tissue::RemoveOutshoneBlobs(std::move(blobs));
  }
  this->CompareWithInverse(this->TakeScales(maxima.inverse, scales), blobs);
  this->SetBlobs(blobs);
  m_NoiseCalculator = nullptr;
  this->UpdateProgress(1.0f);
}

template <typename TInputImage>
bool
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::IsCertain(const tissue::Blob & blob) const
{
  const auto * const image = this->GetInput();
  const auto         spacing = image->GetSpacing();
  const double       voxel = spacing[0] * spacing[1] * spacing[2];
  const double       volume = voxel * static_cast<double>(image->GetLargestPossibleRegion().GetNumberOfPixels());
  const double       places = volume / std::max(voxel, std::pow(blob.scale, 3));
  return blob.response > tissue::LeastBlobEvidence(places) * blob.noise;
}

template <typename TInputImage>
tissue::BlobScaleRange
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::ChooseScales(const std::vector<tissue::Blob> & maxima) const
{
  return this->HasScales() ? this->GetSearchedScales() : tissue::ChooseBlobScales(maxima);
}

template <typename TInputImage>
std::vector<tissue::Blob>
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::TakeScales(std::vector<tissue::Blob>      maxima,
                                                                  const tissue::BlobScaleRange & scales) const
{
  // Where the scales are given, the parabola may lead a little beyond.
  const auto isOther = [&scales](const tissue::Blob & blob) {
    return blob.scale < scales.minimum || blob.scale > scales.maximum;
  };
  if (!this->HasScales())
  {
    maxima.erase(std::remove_if(maxima.begin(), maxima.end(), isOther), maxima.end());
  }
  return tissue::RemoveOverlappingBlobs(std::move(maxima), m_MaximumOverlap);
}

template <typename TInputImage>
double
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::ChooseThreshold(const std::vector<tissue::Blob> & blobs,
                                                                       const std::vector<tissue::Blob> & maxima) const
{
  // A weaker blob never drops a stronger one of those that overlap, so that the threshold may come after this.
  if (m_Threshold > 0.0)
  {
    return m_Threshold;
  }
  if (m_RelativeThreshold > 0.0)
  {
    return blobs.empty() ? 0.0 : m_RelativeThreshold * blobs.front().response;
  }
  return tissue::ChooseBlobThreshold(blobs, this->TakeScales(maxima, this->ChooseScales(maxima)));
}

template <typename TInputImage>
void
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::AddOtherSizes(const std::vector<tissue::Blob> & maxima,
                                                                     std::vector<tissue::Blob> &       blobs)
{
  const tissue::BlobScaleRange scales{ m_UsedMinimumScale, m_UsedMaximumScale };
  for (const tissue::Blob & blob : tissue::FindBlobsOfOtherSizes(maxima, blobs, scales, m_MaximumOverlap))
  {
    if (!this->HasThreshold() || blob.response >= m_UsedThreshold)
    {
      m_UsedMinimumScale = std::min(m_UsedMinimumScale, blob.scale);
      m_UsedMaximumScale = std::max(m_UsedMaximumScale, blob.scale);
      blobs.push_back(blob);
    }
  }
  // A larger blob takes the place of weaker ones that it overlaps, and all are put in order.
  blobs = tissue::RemoveOverlappingBlobs(std::move(blobs), m_MaximumOverlap);
  if (!blobs.empty())
  {
    m_UsedThreshold = std::min(m_UsedThreshold, blobs.back().response);
  }
}

template <typename TInputImage>
void
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::CompareWithInverse(const std::vector<tissue::Blob> & inverse,
                                                                          std::vector<tissue::Blob> &       blobs)
{
  m_HasWeakEvidence = tissue::AreBlobsWeak(blobs, inverse);
  if (m_HasWeakEvidence)
  {
    m_UsedThreshold = std::max(m_UsedThreshold, inverse.front().response);
    const auto isWeak = [this](const tissue::Blob & blob) { return blob.response <= m_UsedThreshold; };
    blobs.erase(std::remove_if(blobs.begin(), blobs.end(), isWeak), blobs.end());
  }
}

template <typename TInputImage>
auto
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::FindMaxima(RealImagePointer               image,
                                                                  const tissue::BlobScaleRange & scales) -> Maxima
{
  // Smooth image after image, each from the one before, and keep the last four: the maxima of the middle one of their
  // three differences are collected.
  const double step = std::pow(2.0, 1.0 / m_StepsPerOctave);
  const auto   numberOfLevels =
    1 + static_cast<unsigned int>(std::ceil(m_StepsPerOctave * std::log2(scales.maximum / scales.minimum) - 1e-9));
  const unsigned int numberOfImages = numberOfLevels + 3;
  // Levels are at the geometric means of their two deviations. One level more on each side shows what is a maximum.
  double deviation = scales.minimum / std::pow(step, 1.5);
  Maxima maxima;
  Window window;
  window[3] = this->Smooth(std::move(image), deviation);
  for (unsigned int i = 1; i < numberOfImages; ++i)
  {
    this->UpdateProgress(static_cast<float>(i) / static_cast<float>(numberOfImages));
    std::rotate(window.begin(), window.begin() + 1, window.end());
    window[3] = nullptr;
    window[3] = this->Smooth(window[2], deviation * std::sqrt(step * step - 1.0));
    deviation *= step;
    const double scale = deviation / std::pow(step, 1.5);
    if (i >= 3)
    {
      this->CollectMaxima(window, scale, step, maxima);
    }
    // A blob between two levels may look like a maximum of one in fine voxels and of the other in coarse ones. So it is
    // looked for in both.
    if (this->HalveWhereSmooth(window, deviation / (step * step)) && i >= 3)
    {
      this->CollectMaxima(window, scale, step, maxima);
    }
  }
  return maxima;
}

template <typename TInputImage>
void
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::CollectMaxima(const Window & window, double scale, double step,
                                                                     Maxima & maxima)
{
  // Only voxels where the difference is positive can be blobs, and those where it is negative of the inverse. Each
  // region collects its own; then they are joined.
  const auto     spacing = this->GetInput()->GetSpacing();
  const Level    level{ scale, step, tissue::NoiseResponse(scale, step, { { spacing[0], spacing[1], spacing[2] } }) };
  std::mutex     mutex;
  WorkUnitErrors errors;
  const auto     collect = [&](const RealImageType::RegionType & region) {
    errors.Run([&]() {
      Maxima                                  found;
      ImageRegionConstIterator<RealImageType> fine(window[1], region);
      ImageRegionConstIterator<RealImageType> coarse(window[2], region);
      for (; !fine.IsAtEnd(); ++fine, ++coarse)
      {
        const auto index = fine.GetIndex();
        if (fine.Get() > coarse.Get())
        {
          this->AppendBlob(window[1], DifferenceOfGaussiansNeighborhood(window, index), index, level, found.blobs);
        }
        else if (fine.Get() < coarse.Get() && !this->HasThreshold())
        {
          const DifferenceOfGaussiansNeighborhood inverse(window, index, -1.0f);
          this->AppendBlob(window[1], inverse, index, level, found.inverse);
        }
      }
      const auto isNoise = [this](const tissue::Blob & blob) { return !this->IsCertain(blob); };
      found.inverse.erase(std::remove_if(found.inverse.begin(), found.inverse.end(), isNoise), found.inverse.end());
      const std::lock_guard<std::mutex> lock(mutex);
      maxima.blobs.insert(maxima.blobs.end(), found.blobs.begin(), found.blobs.end());
      maxima.inverse.insert(maxima.inverse.end(), found.inverse.begin(), found.inverse.end());
    });
  };
  this->GetMultiThreader()->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  this->GetMultiThreader()->template ParallelizeImageRegion<3>(window[0]->GetBufferedRegion(), collect, nullptr);
  errors.Rethrow();
}

template <typename TInputImage>
void
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::AppendBlob(const RealImageType *                     image,
                                                                  const DifferenceOfGaussiansNeighborhood & difference,
                                                                  const IndexType & index, const Level & level,
                                                                  std::vector<tissue::Blob> & blobs) const
{
  tissue::Blob blob;
  if (difference.IsMaximum() && this->FitBlob(image, difference, index, level, blob))
  {
    blob.noise = this->NoiseAt(blob, level);
    blobs.push_back(blob);
  }
}

template <typename TInputImage>
double
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::NoiseAt(const tissue::Blob & blob, const Level & level) const
{
  const InputImageType *     input = this->GetInput();
  const auto                 region = input->GetLargestPossibleRegion();
  const auto                 spacing = input->GetSpacing();
  ContinuousIndex<double, 3> place;
  input->TransformPhysicalPointToContinuousIndex(Point<double, 3>(blob.position.data()), place);
  IndexType index;
  double    border = 1.0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const double first = static_cast<double>(region.GetIndex(axis));
    const double last = first + static_cast<double>(region.GetSize(axis)) - 1.0;
    const double distance = std::max(std::min(place[axis] - first, last - place[axis]), 0.0);
    border *= tissue::BorderNoise(distance, level.scale / spacing[axis]);
    index[axis] = Math::Round<IndexValueType>(place[axis]);
  }
  return std::max(m_Noise, m_NoiseCalculator->GetLocalDeviation(index)) * level.noiseResponse * border;
}

template <typename TInputImage>
bool
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::FitBlob(const RealImageType *                     image,
                                                               const DifferenceOfGaussiansNeighborhood & difference,
                                                               const IndexType & index, const Level & level,
                                                               tissue::Blob & blob) const
{
  // The gradient and the Hessian, by central differences along x, y, z and scale, give the parabola through the
  // neighbours. Its top is -H^-1 g off the middle; the response is the parabola's there.
  using Step = DifferenceOfGaussiansNeighborhood::Step;
  const double                   middle = difference(Step{ { 0, 0, 0, 0 } });
  vnl_vector_fixed<double, 4>    gradient;
  vnl_matrix_fixed<double, 4, 4> hessian;
  for (unsigned int i = 0; i < 4; ++i)
  {
    Step forward{};
    Step backward{};
    forward[i] = 1;
    backward[i] = -1;
    gradient[i] = 0.5 * (difference(forward) - difference(backward));
    hessian(i, i) = difference(forward) + difference(backward) - 2.0 * middle;
    for (unsigned int j = 0; j < i; ++j)
    {
      const auto at = [&](int a, int b) {
        Step both{};
        both[i] = a;
        both[j] = b;
        return difference(both);
      };
      hessian(i, j) = hessian(j, i) = 0.25 * (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1));
    }
  }
  if (!this->IsRound(hessian, image->GetSpacing()))
  {
    return false;
  }

  // Where the top of the four-dimensional parabola is too far to be trusted, those along the single axes are taken,
  // which are half a step off at most. Steps are voxels and levels.
  constexpr double            farthest = 0.75;
  const auto                  solution = vnl_svd<double>(hessian.as_matrix()).solve(-gradient.as_vector());
  vnl_vector_fixed<double, 4> offset;
  const bool isNear = std::all_of(solution.begin(), solution.end(), [](double x) { return std::abs(x) <= farthest; });
  for (unsigned int i = 0; i < 4; ++i)
  {
    // On the border nothing tells on which side of the voxel's centre the top is.
    const bool isOnBorder = i < 3 && (difference.Leaves(i, -1) || difference.Leaves(i, 1));
    offset[i] = isOnBorder            ? 0.0
                : isNear              ? solution[i]
                : hessian(i, i) < 0.0 ? std::clamp(-gradient[i] / hessian(i, i), -0.5, 0.5)
                                      : 0.0;
  }
  ContinuousIndex<double, 3> place;
  for (unsigned int i = 0; i < 3; ++i)
  {
    place[i] = static_cast<double>(index[i]) + offset[i];
  }
  Point<double, 3> position;
  image->TransformContinuousIndexToPhysicalPoint(place, position);
  std::copy_n(position.Begin(), 3, blob.position.begin());
  blob.scale = level.scale * std::pow(level.step, offset[3]);
  blob.response = (middle + 0.5 * dot_product(gradient, offset)) / std::log(level.step);
  return this->IsWithinMargin(position);
}

template <typename TInputImage>
bool
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::IsRound(
  const vnl_matrix_fixed<double, 4, 4> & hessian, const typename RealImageType::SpacingType & spacing) const
{
  if (m_MaximumHessianRatio <= 0.0)
  {
    return true;
  }
  vnl_matrix<double> physical(3, 3);
  for (unsigned int i = 0; i < 3; ++i)
  {
    for (unsigned int j = 0; j < 3; ++j)
    {
      physical(i, j) = hessian(i, j) / (spacing[i] * spacing[j]);
    }
  }
  // The eigenvalues ascend. Those of a blob are all negative, and the last is the weakest.
  const vnl_symmetric_eigensystem<double> eigen(physical);
  return eigen.D(2, 2) < 0.0 && eigen.D(0, 0) >= m_MaximumHessianRatio * eigen.D(2, 2);
}

template <typename TInputImage>
bool
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::IsWithinMargin(const Point<double, 3> & position) const
{
  ContinuousIndex<double, 3> place;
  this->GetInput()->TransformPhysicalPointToContinuousIndex(position, place);
  const auto region = this->GetInput()->GetLargestPossibleRegion();
  const auto spacing = this->GetInput()->GetSpacing();
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double begin = static_cast<double>(region.GetIndex(i)) - 0.5;
    const double end = begin + static_cast<double>(region.GetSize(i));
    if (std::min(place[i] - begin, end - place[i]) * spacing[i] < m_BorderMargin)
    {
      return false;
    }
  }
  return true;
}

template <typename TInputImage>
void
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::SetBlobs(const std::vector<tissue::Blob> & blobs)
{
  const auto points = OutputType::PointsContainer::New();
  const auto data = OutputType::PointDataContainer::New();
  for (std::size_t i = 0; i < blobs.size(); ++i)
  {
    typename OutputType::PointType point;
    std::copy(blobs[i].position.begin(), blobs[i].position.end(), point.Begin());
    BlobDataType values;
    values[0] = blobs[i].scale;
    values[1] = blobs[i].response;
    points->InsertElement(static_cast<typename OutputType::PointIdentifier>(i), point);
    data->InsertElement(static_cast<typename OutputType::PointIdentifier>(i), values);
  }
  this->GetOutput()->SetPoints(points);
  this->GetOutput()->SetPointData(data);
}

template <typename TInputImage>
void
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MinimumScale: " << m_MinimumScale << std::endl;
  os << indent << "MaximumScale: " << m_MaximumScale << std::endl;
  os << indent << "StepsPerOctave: " << m_StepsPerOctave << std::endl;
  os << indent << "DarkBlobs: " << m_DarkBlobs << std::endl;
  os << indent << "Threshold: " << m_Threshold << std::endl;
  os << indent << "RelativeThreshold: " << m_RelativeThreshold << std::endl;
  os << indent << "MaximumOverlap: " << m_MaximumOverlap << std::endl;
  os << indent << "MaximumHessianRatio: " << m_MaximumHessianRatio << std::endl;
  os << indent << "BorderMargin: " << m_BorderMargin << std::endl;
  os << indent << "UsedThreshold: " << m_UsedThreshold << std::endl;
  os << indent << "UsedMinimumScale: " << m_UsedMinimumScale << std::endl;
  os << indent << "UsedMaximumScale: " << m_UsedMaximumScale << std::endl;
  os << indent << "Noise: " << m_Noise << std::endl;
  os << indent << "HasWeakEvidence: " << m_HasWeakEvidence << std::endl;
}
} // namespace itk

#endif
