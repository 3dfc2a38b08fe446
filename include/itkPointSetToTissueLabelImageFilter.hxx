/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkPointSetToTissueLabelImageFilter_hxx
#define itkPointSetToTissueLabelImageFilter_hxx

#include "itkPointSetToTissueLabelImageFilter.h"

#include "TissueTessellationCore/Geometry/PointRange.h"
#include "TissueTessellationCore/Points/PointTissue.h"
#include "itkContinuousIndex.h"
#include "itkCoreExecution.h"

#include <algorithm>
#include <stdexcept>

namespace itk
{
template <typename TPointSet, typename TLabelImage>
PointSetToTissueLabelImageFilter<TPointSet, TLabelImage>::PointSetToTissueLabelImageFilter()
{
  this->SetNumberOfRequiredInputs(1);
  this->AddOptionalInputName("ReferenceImage", 1);
  this->ProcessObject::SetOutput("Votes", this->MakeOutput("Votes"));
}

template <typename TPointSet, typename TLabelImage>
ProcessObject::DataObjectPointer
PointSetToTissueLabelImageFilter<TPointSet, TLabelImage>::MakeOutput(
  const ProcessObject::DataObjectIdentifierType & name)
{
  if (name == "Votes")
  {
    return TissueVotes::New().GetPointer();
  }
  return Superclass::MakeOutput(name);
}

template <typename TPointSet, typename TLabelImage>
TissueVotes *
PointSetToTissueLabelImageFilter<TPointSet, TLabelImage>::GetVotes()
{
  return itkDynamicCastInDebugMode<TissueVotes *>(this->ProcessObject::GetOutput("Votes"));
}

template <typename TPointSet, typename TLabelImage>
const TissueVotes *
PointSetToTissueLabelImageFilter<TPointSet, TLabelImage>::GetVotes() const
{
  return itkDynamicCastInDebugMode<const TissueVotes *>(this->ProcessObject::GetOutput("Votes"));
}

template <typename TPointSet, typename TLabelImage>
void
PointSetToTissueLabelImageFilter<TPointSet, TLabelImage>::SetInput(const PointSetType * points)
{
  this->SetNthInput(0, const_cast<PointSetType *>(points));
}

template <typename TPointSet, typename TLabelImage>
auto
PointSetToTissueLabelImageFilter<TPointSet, TLabelImage>::GetInput() const -> const PointSetType *
{
  return itkDynamicCastInDebugMode<const PointSetType *>(this->GetPrimaryInput());
}

template <typename TPointSet, typename TLabelImage>
std::vector<tissue::Point>
PointSetToTissueLabelImageFilter<TPointSet, TLabelImage>::MakePoints() const
{
  const ReferenceImageType * const reference = this->GetReferenceImage();
  std::vector<tissue::Point>       points;
  if (this->GetInput()->GetNumberOfPoints() == 0)
  {
    return points;
  }
  const auto * const container = this->GetInput()->GetPoints();
  for (auto it = container->Begin(); it != container->End(); ++it)
  {
    itk::Point<double, 3> physical;
    physical.CastFrom(it.Value());
    tissue::Point point = { { physical[0], physical[1], physical[2] } };
    if (reference != nullptr)
    {
      const auto index = reference->TransformPhysicalPointToContinuousIndex<double>(physical);
      for (unsigned int i = 0; i < 3; ++i)
      {
        point[i] = (index[i] - reference->GetLargestPossibleRegion().GetIndex(i) + 0.5) * reference->GetSpacing()[i];
      }
    }
    points.push_back(point);
  }
  return points;
}

template <typename TPointSet, typename TLabelImage>
void
PointSetToTissueLabelImageFilter<TPointSet, TLabelImage>::RefusePointsOutside(const std::vector<tissue::Point> & points,
                                                                              const tissue::Box & box) const
{
  if (const auto outside = tissue::FindPointOutside(points, box))
  {
    auto it = this->GetInput()->GetPoints()->Begin();
    for (std::size_t i = 0; i < *outside; ++i)
    {
      ++it;
    }
    const ReferenceImageType * const reference = this->GetReferenceImage();
    itkExceptionMacro("point " << it.Index() << " at " << it.Value()
                               << " is outside of the box of the reference image, which has the size "
                               << reference->GetLargestPossibleRegion().GetSize() << ", the spacing "
                               << reference->GetSpacing() << " and the origin " << reference->GetOrigin());
  }
}

template <typename TPointSet, typename TLabelImage>
void
PointSetToTissueLabelImageFilter<TPointSet, TLabelImage>::GenerateOutputInformation()
{
  // The grid is made in the space of the points, which with a reference image is along its axes from its corner. The
  // output then gets the grid's spacing and size, and the place of its first point by the reference image.
  if (const auto source = this->GetInput()->GetSource())
  {
    source->Update();
  }
  const std::vector<tissue::Point> points = this->MakePoints();
  if (points.size() > static_cast<uint64_t>(NumericTraits<LabelPixelType>::max()))
  {
    itkExceptionMacro("There are " << points.size() << " points, but the pixel type's greatest label is "
                                   << NumericTraits<LabelPixelType>::max() + 0);
  }
  LabelImageType * const           output = this->GetOutput();
  const ReferenceImageType * const reference = this->GetReferenceImage();
  try
  {
    tissue::Box box{};
    if (reference != nullptr)
    {
      for (unsigned int i = 0; i < 3; ++i)
      {
        box.upper[i] = reference->GetLargestPossibleRegion().GetSize(i) * reference->GetSpacing()[i];
      }
    }
    else
    {
      box = tissue::PaddedBox(points);
    }
    m_Grid = tissue::MakePointGrid(points, box, m_VoxelsPerCell);
    this->RefusePointsOutside(points, box);
  }
  catch (const std::invalid_argument & error)
  {
    itkExceptionMacro(<< error.what());
  }
  const tissue::Point                first = m_Grid.Position(0, 0, 0);
  typename LabelImageType::PointType origin;
  typename LabelImageType::SizeType  size;
  ContinuousIndex<double, 3>         index;
  for (unsigned int i = 0; i < 3; ++i)
  {
    origin[i] = first[i];
    size[i] = static_cast<SizeValueType>(m_Grid.size[i]);
    if (reference != nullptr)
    {
      index[i] = first[i] / reference->GetSpacing()[i] - 0.5 + reference->GetLargestPossibleRegion().GetIndex(i);
    }
  }
  if (reference != nullptr)
  {
    reference->TransformContinuousIndexToPhysicalPoint(index, origin);
    output->SetDirection(reference->GetDirection());
  }
  output->SetSpacing(m_Grid.steps.data());
  output->SetOrigin(origin);
  output->SetLargestPossibleRegion(typename LabelImageType::RegionType(size));
}

template <typename TPointSet, typename TLabelImage>
void
PointSetToTissueLabelImageFilter<TPointSet, TLabelImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TPointSet, typename TLabelImage>
void
PointSetToTissueLabelImageFilter<TPointSet, TLabelImage>::GenerateData()
{
  this->AllocateOutputs();
  const auto layering = m_Layer == LayerEnum::On    ? tissue::TissueLayering::Layer
                        : m_Layer == LayerEnum::Off ? tissue::TissueLayering::Solid
                                                    : tissue::TissueLayering::Automatic;
  auto       tissue = RunCore(this, [this, layering] {
    return tissue::EstimateTissue(this->MakePoints(), m_Grid, layering, MakeExecution(this));
  });
  this->GetVotes()->SetVotes(std::move(tissue.votes));
  std::transform(tissue.labels.begin(),
                 tissue.labels.end(),
                 this->GetOutput()->GetBufferPointer(),
                 [](std::int32_t label) { return static_cast<LabelPixelType>(label); });
}

template <typename TPointSet, typename TLabelImage>
void
PointSetToTissueLabelImageFilter<TPointSet, TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "VoxelsPerCell: " << m_VoxelsPerCell << std::endl;
  os << indent << "Layer: " << m_Layer << std::endl;
}
} // namespace itk

#endif
