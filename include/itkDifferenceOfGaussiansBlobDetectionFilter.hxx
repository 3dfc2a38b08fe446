/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkDifferenceOfGaussiansBlobDetectionFilter_hxx
#define itkDifferenceOfGaussiansBlobDetectionFilter_hxx

#include "itkDifferenceOfGaussiansBlobDetectionFilter.h"

#include "itkContinuousIndex.h"
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
/** \brief The difference of smoothed images around a voxel, in steps of voxels and levels. Beyond the border of the
 * image it goes on as it is on the border, as in the Gaussian filters. */
class DifferenceOfGaussiansNeighborhood
{
public:
  using ImageType = Image<float, 3>;
  using Step = std::array<int, 4>;

  DifferenceOfGaussiansNeighborhood(const std::array<ImageType::Pointer, 4> & window, const Index<3> & index)
    : m_Strides(window[0]->GetOffsetTable())
  {
    const auto            region = window[0]->GetBufferedRegion();
    const OffsetValueType offset = window[0]->ComputeOffset(index);
    std::transform(window.begin(), window.end(), m_Voxels.begin(), [offset](const ImageType * image) {
      return image->GetBufferPointer() + offset;
    });
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const auto step = index[axis] - region.GetIndex(axis);
      m_IsFirst[axis] = step == 0;
      m_IsLast[axis] = step + 1 == static_cast<IndexValueType>(region.GetSize(axis));
    }
  }

  /** Tells whether a step of one leaves the image. */
  bool
  Leaves(std::size_t axis, int step) const
  {
    return (step < 0 && m_IsFirst[axis]) || (step > 0 && m_IsLast[axis]);
  }

  double
  operator()(const Step & step) const
  {
    OffsetValueType offset = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      offset += this->Leaves(axis, step[axis]) ? 0 : step[axis] * m_Strides[axis];
    }
    const auto level = static_cast<std::size_t>(1 + step[3]);
    return m_Voxels[level][offset] - m_Voxels[level + 1][offset];
  }

  /** Tells whether the middle is above its 80 neighbours. Of equal ones the first in raster order is. */
  bool
  IsMaximum() const
  {
    const double middle = (*this)({ { 0, 0, 0, 0 } });
    for (const int level : { 0, -1, 1 })
    {
      // Most voxels fail on the slope that they lie on, whatever its direction.
      for (const int i :
           { 12, 14, 10, 16, 4, 22, 0, 1, 2, 3, 5, 6, 7, 8, 9, 11, 13, 15, 17, 18, 19, 20, 21, 23, 24, 25, 26 })
      {
        const Step step{ { i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1, level } };
        if ((level == 0 && i == 13) || this->Leaves(0, step[0]) || this->Leaves(1, step[1]) || this->Leaves(2, step[2]))
        {
          continue;
        }
        const double other = (*this)(step);
        const bool   isBefore = level < 0 || (level == 0 && i < 13);
        if ((isBefore ? other >= middle : other > middle))
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  std::array<const float *, 4> m_Voxels{};
  const OffsetValueType *      m_Strides;
  std::array<bool, 3>          m_IsFirst{};
  std::array<bool, 3>          m_IsLast{};
};

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
    // The ball that answers at this scale is already more than half as wide as the shortest side.
    constexpr double largestShare = 1.0 / 6.0;
    return { finest, std::max(finest, largestShare * shortest) };
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
  tissue::BlobScaleRange    scales = this->GetSearchedScales();
  std::vector<tissue::Blob> blobs = this->FindMaxima(scales);
  if (!this->HasScales())
  {
    scales = tissue::ChooseBlobScales(blobs);
    const auto isOther = [&scales](const tissue::Blob & blob) {
      return blob.scale < scales.minimum || blob.scale > scales.maximum;
    };
    blobs.erase(std::remove_if(blobs.begin(), blobs.end(), isOther), blobs.end());
  }
  m_UsedMinimumScale = scales.minimum;
  m_UsedMaximumScale = scales.maximum;
  this->SetBlobs(this->SelectBlobs(std::move(blobs)));
  this->UpdateProgress(1.0f);
}

template <typename TInputImage>
std::vector<tissue::Blob>
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::FindMaxima(const tissue::BlobScaleRange & scales)
{
  // Smooth image after image, each from the one before, and keep the last four: the maxima of the middle one of their
  // three differences are collected.
  const double step = std::pow(2.0, 1.0 / m_StepsPerOctave);
  const auto   numberOfLevels =
    1 + static_cast<unsigned int>(std::ceil(m_StepsPerOctave * std::log2(scales.maximum / scales.minimum) - 1e-9));
  const unsigned int numberOfImages = numberOfLevels + 3;
  // Levels are at the geometric means of their two deviations. One level more on each side shows what is a maximum.
  double                    deviation = scales.minimum / std::pow(step, 1.5);
  std::vector<tissue::Blob> blobs;
  Window                    window;
  window[3] = this->Smooth(this->ConvertInput(), deviation);
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
      this->CollectMaxima(window, scale, step, blobs);
    }
    // A blob between two levels may look like a maximum of one in fine voxels and of the other in coarse ones. So it is
    // looked for in both.
    if (this->HalveWhereSmooth(window, deviation / (step * step)) && i >= 3)
    {
      this->CollectMaxima(window, scale, step, blobs);
    }
  }
  return blobs;
}

template <typename TInputImage>
void
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::CollectMaxima(const Window & window, double scale, double step,
                                                                     std::vector<tissue::Blob> & blobs)
{
  // Only voxels where the difference is positive can be blobs. Each region collects its own; then they are joined.
  std::mutex     mutex;
  WorkUnitErrors errors;
  const auto     collect = [&](const RealImageType::RegionType & region) {
    errors.Run([&]() {
      std::vector<tissue::Blob>               found;
      ImageRegionConstIterator<RealImageType> fine(window[1], region);
      ImageRegionConstIterator<RealImageType> coarse(window[2], region);
      for (; !fine.IsAtEnd(); ++fine, ++coarse)
      {
        if (fine.Get() > coarse.Get())
        {
          const DifferenceOfGaussiansNeighborhood difference(window, fine.GetIndex());
          tissue::Blob                            blob;
          if (difference.IsMaximum() && this->FitBlob(window[1], difference, fine.GetIndex(), scale, step, blob))
          {
            found.push_back(blob);
          }
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      blobs.insert(blobs.end(), found.begin(), found.end());
    });
  };
  this->GetMultiThreader()->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  this->GetMultiThreader()->template ParallelizeImageRegion<3>(window[0]->GetBufferedRegion(), collect, nullptr);
  errors.Rethrow();
}

template <typename TInputImage>
bool
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::FitBlob(const RealImageType *                     image,
                                                               const DifferenceOfGaussiansNeighborhood & difference,
                                                               const IndexType & index, double scale, double step,
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
  blob.scale = scale * std::pow(step, offset[3]);
  blob.response = (middle + 0.5 * dot_product(gradient, offset)) / std::log(step);
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
std::vector<tissue::Blob>
DifferenceOfGaussiansBlobDetectionFilter<TInputImage>::SelectBlobs(std::vector<tissue::Blob> blobs)
{
  // A weaker blob never drops a stronger one, so that the threshold may come after this.
  blobs = tissue::RemoveOverlappingBlobs(std::move(blobs), m_MaximumOverlap);
  if (m_Threshold > 0.0)
  {
    m_UsedThreshold = m_Threshold;
  }
  else if (m_RelativeThreshold > 0.0)
  {
    m_UsedThreshold = blobs.empty() ? 0.0 : m_RelativeThreshold * blobs.front().response;
  }
  else
  {
    std::vector<double> responses;
    for (const tissue::Blob & blob : blobs)
    {
      responses.push_back(blob.response);
    }
    m_UsedThreshold = tissue::ChooseBlobThreshold(std::move(responses));
  }
  const auto isWeak = [this](const tissue::Blob & blob) { return blob.response < m_UsedThreshold; };
  blobs.erase(std::find_if(blobs.begin(), blobs.end(), isWeak), blobs.end());
  return blobs;
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
}
} // namespace itk

#endif
