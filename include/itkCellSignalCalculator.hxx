/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCellSignalCalculator_hxx
#define itkCellSignalCalculator_hxx

#include "itkCellSignalCalculator.h"

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "itkCastImageFilter.h"
#include "itkCoreExecution.h"
#include "itkLinearInterpolateImageFunction.h"
#include "itkResampleImageFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
template <typename TInputImage>
CellSignalCalculator<TInputImage>::CellSignalCalculator()
  : m_MultiThreader(MultiThreaderBase::New())
{}

template <typename TInputImage>
void
CellSignalCalculator<TInputImage>::SetNumberOfWorkUnits(ThreadIdType number)
{
  m_MultiThreader->SetNumberOfWorkUnits(number);
}

template <typename TInputImage>
ThreadIdType
CellSignalCalculator<TInputImage>::GetNumberOfWorkUnits() const
{
  return m_MultiThreader->GetNumberOfWorkUnits();
}

template <typename TInputImage>
void
CellSignalCalculator<TInputImage>::CheckInputs() const
{
  if (!m_Image || !m_LabelVolume || !m_Mesh)
  {
    itkExceptionMacro("The " << (!m_Image ? "image" : !m_LabelVolume ? "label volume" : "mesh") << " is not set.");
  }
  if (m_Image->GetBufferedRegion().GetNumberOfPixels() == 0)
  {
    itkExceptionMacro("The image is empty.");
  }
  const auto &           vertices = m_LabelVolume->GetLabelVolume().vertices;
  const tissue::VertexId largest = vertices.empty() ? -1 : *std::max_element(vertices.begin(), vertices.end());
  const auto             numberOfVertices = m_Mesh->GetJunctionSet().NumberOfVertices();
  if (largest + 1 < numberOfVertices)
  {
    itkExceptionMacro("The label volume has " << std::max(largest, 0) << " cells, the mesh is of "
                                              << numberOfVertices - 1 << ".");
  }
}

template <typename TInputImage>
auto
CellSignalCalculator<TInputImage>::MakeField() const -> typename FieldType::Pointer
{
  const tissue::LabelVolume & labels = m_LabelVolume->GetLabelVolume();
  const auto                  spacing = m_Image->GetSpacing();
  const double                volume = spacing[0] * spacing[1] * spacing[2];
  constexpr double            tolerance = 1e-6;
  if (volume <= (1.0 + tolerance) * std::pow(labels.VoxelLength(), 3.0))
  {
    const auto cast = CastImageFilter<ImageType, FieldType>::New();
    cast->SetInput(m_Image);
    cast->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
    cast->Update();
    return cast->GetOutput();
  }
  const auto                        resample = ResampleImageFilter<ImageType, FieldType>::New();
  typename FieldType::SizeType      size;
  typename FieldType::PointType     origin(labels.origin.data());
  typename FieldType::SpacingType   spacingOfLabels;
  typename FieldType::DirectionType direction;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<SizeValueType>(labels.size[axis]);
    spacingOfLabels[axis] = tissue::Norm(labels.steps[axis]);
    for (unsigned int row = 0; row < 3; ++row)
    {
      direction[row][axis] = labels.steps[axis][row] / spacingOfLabels[axis];
    }
  }
  resample->SetInput(m_Image);
  resample->SetSize(size);
  resample->SetOutputOrigin(origin);
  resample->SetOutputSpacing(spacingOfLabels);
  resample->SetOutputDirection(direction);
  resample->SetDefaultPixelValue(std::numeric_limits<float>::quiet_NaN());
  resample->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  resample->Update();
  return resample->GetOutput();
}

template <typename TInputImage>
std::vector<double>
CellSignalCalculator<TInputImage>::MeasureWalls(const tissue::WallMesh & mesh) const
{
  const auto interpolator = LinearInterpolateImageFunction<ImageType, double>::New();
  interpolator->SetInputImage(m_Image);
  const auto   spacing = m_Image->GetSpacing();
  const double step = std::min({ spacing[0], spacing[1], spacing[2] });
  return tissue::MeasureOnWalls(
    mesh,
    step,
    [&interpolator](const tissue::Point & position) {
      const typename ImageType::PointType point(position.data());
      return interpolator->IsInsideBuffer(point) ? static_cast<double>(interpolator->Evaluate(point))
                                                 : tissue::UnknownStatistic;
    },
    MakeExecution(m_MultiThreader));
}

template <typename TInputImage>
void
CellSignalCalculator<TInputImage>::Compute()
{
  m_CellSignals.clear();
  m_WallMeans.clear();
  this->CheckInputs();
  m_UsedWallDistance = m_WallDistance > 0.0 ? m_WallDistance : m_Image->GetSpacing().GetNorm();
  const typename FieldType::Pointer field = this->MakeField();
  tissue::ImageGrid                 grid;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const auto region = field->GetBufferedRegion();
    auto       next = region.GetIndex();
    ++next[axis];
    const auto first = field->template TransformIndexToPhysicalPoint<double>(region.GetIndex());
    const auto second = field->template TransformIndexToPhysicalPoint<double>(next);
    grid.size[axis] = static_cast<std::int32_t>(region.GetSize(axis));
    for (unsigned int row = 0; row < 3; ++row)
    {
      grid.origin[row] = first[row];
      grid.steps[axis][row] = second[row] - first[row];
    }
  }
  RunCore(this, [&] {
    const tissue::WallMesh & mesh = m_Mesh->GetWallMesh();
    m_CellSignals = tissue::MeasureSignal(m_LabelVolume->GetLabelVolume(),
                                          grid,
                                          field->GetBufferPointer(),
                                          mesh,
                                          m_Mesh->GetJunctionSet().NumberOfVertices(),
                                          m_UsedWallDistance,
                                          MakeExecution(m_MultiThreader));
    m_WallMeans = this->MeasureWalls(mesh);
  });
  if (std::none_of(m_CellSignals.begin(), m_CellSignals.end(), [](const tissue::CellSignal & signal) {
        return signal.knownVolume > 0.0;
      }))
  {
    m_CellSignals.clear();
    m_WallMeans.clear();
    itkExceptionMacro("No voxel of the image that has a finite value is in a cell.");
  }
}

template <typename TInputImage>
auto
CellSignalCalculator<TInputImage>::Collect(double tissue::CellSignal::*member) const -> ValuesContainer::Pointer
{
  const auto values = ValuesContainer::New();
  for (SizeValueType v = 1; v < m_CellSignals.size(); ++v)
  {
    values->push_back(m_CellSignals[v].*member);
  }
  return values;
}

template <typename TInputImage>
auto
CellSignalCalculator<TInputImage>::GetMeans() const -> ValuesContainer::Pointer
{
  return this->Collect(&tissue::CellSignal::mean);
}

template <typename TInputImage>
auto
CellSignalCalculator<TInputImage>::GetIntegrals() const -> ValuesContainer::Pointer
{
  return this->Collect(&tissue::CellSignal::integral);
}

template <typename TInputImage>
auto
CellSignalCalculator<TInputImage>::GetMeansNearWalls() const -> ValuesContainer::Pointer
{
  return this->Collect(&tissue::CellSignal::meanNearWalls);
}

template <typename TInputImage>
auto
CellSignalCalculator<TInputImage>::GetMeansOfWalls() const -> ValuesContainer::Pointer
{
  const auto values = ValuesContainer::New();
  values->CastToSTLContainer() = m_WallMeans;
  return values;
}

template <typename TInputImage>
void
CellSignalCalculator<TInputImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "WallDistance: " << m_WallDistance << std::endl;
  os << indent << "UsedWallDistance: " << m_UsedWallDistance << std::endl;
}
} // namespace itk

#endif
