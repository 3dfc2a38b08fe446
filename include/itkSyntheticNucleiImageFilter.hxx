/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkSyntheticNucleiImageFilter_hxx
#define itkSyntheticNucleiImageFilter_hxx

#include "itkSyntheticNucleiImageFilter.h"

#include "TissueTessellationCore/Common/Random.h"
#include "itkAdditiveGaussianNoiseImageFilter.h"
#include "itkDiscreteGaussianImageFilter.h"
#include "itkImageRegionConstIterator.h"
#include "itkImageRegionConstIteratorWithIndex.h"
#include "itkImageRegionIterator.h"
#include "itkShotNoiseImageFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
template <typename TLabelImage>
SyntheticNucleiImageFilter<TLabelImage>::SyntheticNucleiImageFilter()
  : m_Nuclei(NucleiType::New())
{}

template <typename TLabelImage>
void
SyntheticNucleiImageFilter<TLabelImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  const_cast<LabelImageType *>(this->GetInput())->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TLabelImage>
void
SyntheticNucleiImageFilter<TLabelImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TLabelImage>
auto
SyntheticNucleiImageFilter<TLabelImage>::PlaceNuclei() const -> Nuclei
{
  // One pass finds the centroids and the volumes of the cells; then each nucleus, in the order of the labels, is placed
  // uniformly in a ball about the centroid and gets its radius and its brightness.
  const LabelImageType * labels = this->GetInput();
  Nuclei                 nuclei;
  for (ImageRegionConstIteratorWithIndex<LabelImageType> it(labels, labels->GetLargestPossibleRegion()); !it.IsAtEnd();
       ++it)
  {
    if (it.Get() != m_ExteriorLabel)
    {
      Nucleus &        nucleus = nuclei[it.Get()];
      Point<double, 3> place;
      labels->TransformIndexToPhysicalPoint(it.GetIndex(), place);
      nucleus.cellVolume += 1.0;
      nucleus.cellCenter += (place - nucleus.cellCenter) / nucleus.cellVolume;
    }
  }
  const auto     spacing = labels->GetSpacing();
  tissue::Random random(m_Seed);
  for (auto & [label, nucleus] : nuclei)
  {
    nucleus.cellVolume *= spacing[0] * spacing[1] * spacing[2];
    const double      cellRadius = std::cbrt(nucleus.cellVolume * 3.0 / (4.0 * Math::pi));
    Vector<double, 3> offset;
    do
    {
      for (double & component : offset)
      {
        component = 2.0 * random.Uniform() - 1.0;
      }
    } while (offset.GetNorm() > 1.0);
    nucleus.center = nucleus.cellCenter + offset * (m_Decentering * cellRadius);
    nucleus.radius = m_RadiusShare * cellRadius * (0.8 + 0.4 * random.Uniform());
    nucleus.brightness = 0.7 + 0.6 * random.Uniform();
  }
  return nuclei;
}

template <typename TLabelImage>
auto
SyntheticNucleiImageFilter<TLabelImage>::PaintNuclei(Nuclei & nuclei) const -> RealImagePointer
{
  // A voxel shows its own cell's nucleus alone, by the share of it that is in the ball. The same shares give the
  // centroid of what was painted.
  const LabelImageType * labels = this->GetInput();
  const auto             spacing = labels->GetSpacing();
  const double           voxel = std::cbrt(spacing[0] * spacing[1] * spacing[2]);
  const auto             image = RealImageType::New();
  image->CopyInformation(labels);
  image->SetRegions(labels->GetLargestPossibleRegion());
  image->Allocate();
  ImageRegionIterator<RealImageType> out(image, image->GetLargestPossibleRegion());
  for (ImageRegionConstIteratorWithIndex<LabelImageType> it(labels, labels->GetLargestPossibleRegion()); !it.IsAtEnd();
       ++it, ++out)
  {
    const auto at = it.Get() != m_ExteriorLabel ? nuclei.find(it.Get()) : nuclei.end();
    double     share = 0.0;
    if (at != nuclei.end())
    {
      Nucleus &        nucleus = at->second;
      Point<double, 3> place;
      labels->TransformIndexToPhysicalPoint(it.GetIndex(), place);
      // This is nearly the part of the voxel that is within the ball.
      share = std::clamp(0.5 + (nucleus.radius - place.EuclideanDistanceTo(nucleus.center)) / voxel, 0.0, 1.0);
      if (share > 0.0)
      {
        nucleus.weight += share;
        nucleus.centroid += (place - nucleus.centroid) * (share / nucleus.weight);
      }
      share *= nucleus.brightness;
    }
    out.Set(static_cast<float>(share));
  }
  return image;
}

template <typename TLabelImage>
auto
SyntheticNucleiImageFilter<TLabelImage>::BlurAndCount(RealImagePointer image) const -> RealImagePointer
{
  // At a nucleus of mean brightness, s photons on a background of a fifth of them, the noise of counting and that of
  // reading have the variance 1.2 s each, so that the signal is s / sqrt(2.4 s) times the deviation.
  constexpr double background = 0.2;
  const double     photons = 2.0 * (1.0 + background) * m_SignalToNoise * m_SignalToNoise;
  if (m_Blur > 0.0)
  {
    const auto blur = DiscreteGaussianImageFilter<RealImageType, RealImageType>::New();
    blur->SetInput(image);
    blur->SetUseImageSpacing(false);
    blur->SetVariance(m_Blur * m_Blur);
    blur->Update();
    image = blur->GetOutput();
  }
  for (ImageRegionIterator<RealImageType> it(image, image->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it)
  {
    it.Set(static_cast<float>(photons * (it.Get() + background)));
  }
  // The noise filters' random numbers depend on the number of work units, so each has one alone.
  const auto counted = ShotNoiseImageFilter<RealImageType>::New();
  counted->SetInput(image);
  counted->SetSeed(m_Seed);
  counted->SetNumberOfWorkUnits(1);
  const auto read = AdditiveGaussianNoiseImageFilter<RealImageType>::New();
  read->SetInput(counted->GetOutput());
  read->SetStandardDeviation(std::sqrt(photons * (1.0 + background)));
  read->SetSeed(m_Seed + 1);
  read->SetNumberOfWorkUnits(1);
  read->Update();
  return read->GetOutput();
}

template <typename TLabelImage>
void
SyntheticNucleiImageFilter<TLabelImage>::GenerateData()
{
  // Check the parameters; make the image of the nuclei; clamp it to pixels; list the nuclei that have been painted.
  if (!(m_RadiusShare > 0.0 && m_RadiusShare < 1.0))
  {
    itkExceptionMacro(<< "The radius share is " << m_RadiusShare << ", must be above 0 and below 1.");
  }
  // Pixels could not hold the photons of a much greater ratio of signal to noise.
  constexpr double most = 100.0;
  if (!(m_SignalToNoise > 0.0 && m_SignalToNoise <= most))
  {
    itkExceptionMacro(<< "The signal to noise is " << m_SignalToNoise << ", must be above 0 and at most " << most);
  }
  if (!(m_Blur >= 0.0 && m_Blur <= most) || !(m_Decentering >= 0.0 && m_Decentering <= most))
  {
    itkExceptionMacro(<< "Blur is " << m_Blur << " and decentering " << m_Decentering << ", must be at least 0 and at "
                      << "most " << most);
  }
  Nuclei     nuclei = this->PlaceNuclei();
  const auto seen = this->BlurAndCount(this->PaintNuclei(nuclei));

  // The scanner's own offset keeps values that noise takes below zero.
  const double offset = 20.0 * m_SignalToNoise;
  this->AllocateOutputs();
  ImageRegionConstIterator<RealImageType> in(seen, seen->GetLargestPossibleRegion());
  for (ImageRegionIterator<OutputImageType> it(this->GetOutput(), this->GetOutput()->GetLargestPossibleRegion());
       !it.IsAtEnd();
       ++it, ++in)
  {
    constexpr double most = std::numeric_limits<std::uint16_t>::max();
    it.Set(static_cast<std::uint16_t>(std::clamp(std::round(in.Get() + offset), 0.0, most)));
  }

  const auto points = NucleiType::PointsContainer::New();
  const auto data = NucleiType::PointDataContainer::New();
  for (const auto & [label, nucleus] : nuclei)
  {
    if (nucleus.weight > 0.0)
    {
      NucleusDataType values;
      values[0] = static_cast<double>(label);
      values[1] = nucleus.radius;
      const auto id = points->Size();
      points->InsertElement(id, nucleus.centroid);
      data->InsertElement(id, values);
    }
  }
  m_Nuclei->SetPoints(points);
  m_Nuclei->SetPointData(data);
}

template <typename TLabelImage>
void
SyntheticNucleiImageFilter<TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "ExteriorLabel: " << static_cast<typename NumericTraits<LabelType>::PrintType>(m_ExteriorLabel)
     << std::endl;
  os << indent << "RadiusShare: " << m_RadiusShare << std::endl;
  os << indent << "Decentering: " << m_Decentering << std::endl;
  os << indent << "Blur: " << m_Blur << std::endl;
  os << indent << "SignalToNoise: " << m_SignalToNoise << std::endl;
  os << indent << "Seed: " << m_Seed << std::endl;
}
} // namespace itk

#endif
