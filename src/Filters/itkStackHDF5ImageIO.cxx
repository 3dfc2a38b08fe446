/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkStackHDF5ImageIO.h"

#include "HDF5Datasets.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>

namespace itk
{
namespace
{
using tissue::HDF5Dataset;

IOComponentEnum
ToComponentType(const HDF5Dataset & dataset)
{
  const bool isSigned = dataset.kind == 'i';
  if (dataset.kind == 'f')
  {
    return dataset.bytes == 4 ? IOComponentEnum::FLOAT : IOComponentEnum::DOUBLE;
  }
  switch (dataset.bytes)
  {
    case 1:
      return isSigned ? IOComponentEnum::CHAR : IOComponentEnum::UCHAR;
    case 2:
      return isSigned ? IOComponentEnum::SHORT : IOComponentEnum::USHORT;
    case 4:
      return isSigned ? IOComponentEnum::INT : IOComponentEnum::UINT;
    case 8:
      return isSigned ? IOComponentEnum::LONGLONG : IOComponentEnum::ULONGLONG;
    default:
      return IOComponentEnum::UNKNOWNCOMPONENTTYPE;
  }
}

/** The first of them, for a message. */
std::string
List(const std::vector<HDF5Dataset> & datasets)
{
  constexpr std::size_t most = 10;
  std::string           text;
  for (std::size_t i = 0; i < std::min(most, datasets.size()); ++i)
  {
    text += (i > 0 ? ", " : "") + datasets[i].Describe();
  }
  return text + (datasets.size() > most ? ", ..." : "");
}

/** The only one that is of a kind; null where there are none or several. */
const HDF5Dataset *
FindOnly(const std::vector<HDF5Dataset> & datasets, const std::function<bool(const HDF5Dataset &)> & isOfKind)
{
  const auto first = std::find_if(datasets.begin(), datasets.end(), isOfKind);
  return std::count_if(datasets.begin(), datasets.end(), isOfKind) == 1 ? &*first : nullptr;
}

/** \throws std::runtime_error that names those that there are. */
HDF5Dataset
Choose(const std::vector<HDF5Dataset> & datasets, const std::string & name, bool prefersIntegers)
{
  const HDF5Dataset * chosen = nullptr;
  const auto          isVolume = [](const HDF5Dataset & dataset) { return dataset.IsVolume(); };
  const auto isOfIntegers = [](const HDF5Dataset & dataset) { return dataset.IsVolume() && dataset.kind != 'f'; };
  const auto isNamed = [&name](const HDF5Dataset & dataset) {
    return dataset.name == name || dataset.name == "/" + name;
  };
  if (!name.empty())
  {
    chosen = FindOnly(datasets, isNamed);
  }
  else
  {
    chosen = FindOnly(datasets, isVolume);
    chosen = chosen == nullptr && prefersIntegers ? FindOnly(datasets, isOfIntegers) : chosen;
  }
  if (chosen != nullptr)
  {
    return *chosen;
  }
  if (datasets.empty())
  {
    throw std::runtime_error("the HDF5 file has no data set of numbers");
  }
  throw std::runtime_error((name.empty() ? "it is not clear which data set of the HDF5 file is meant"
                                         : "the HDF5 file has no data set '" + name + "'") +
                           "; it has " + List(datasets) + "; FILE:/NAME names one");
}
} // namespace

StackHDF5ImageIO::StackHDF5ImageIO()
{
  for (const char * extension : { ".h5", ".hdf5", ".hdf" })
  {
    this->AddSupportedReadExtension(extension);
  }
}

StackHDF5ImageIO::~StackHDF5ImageIO() = default;

std::pair<std::string, std::string>
StackHDF5ImageIO::SplitPath(const std::string & path)
{
  std::error_code   ignored;
  const std::size_t colon = path.rfind(':');
  if (colon == std::string::npos || std::filesystem::exists(path, ignored))
  {
    return { path, {} };
  }
  const std::string file = path.substr(0, colon);
  return std::filesystem::is_regular_file(file, ignored) ? std::make_pair(file, path.substr(colon + 1))
                                                         : std::make_pair(path, std::string());
}

bool
StackHDF5ImageIO::CanReadFile(const char * path)
{
  const std::string file = SplitPath(path).first;
  std::ifstream     stream(file, std::ios::binary);
  char              signature[8] = {};
  if (!stream.read(signature, sizeof(signature)) || std::string(signature, 8) != "\x89HDF\r\n\x1A\n")
  {
    return false;
  }
  try
  {
    const auto datasets = tissue::ListHDF5Datasets(file);
    return std::none_of(datasets.begin(), datasets.end(), [](const HDF5Dataset & dataset) {
      return dataset.name.rfind("/ITKImage/", 0) == 0 || dataset.name.rfind("/minc-2.0/", 0) == 0;
    });
  }
  catch (const std::runtime_error &)
  {
    // It is said what is wrong with it when it is read.
    return true;
  }
}

void
StackHDF5ImageIO::ReadImageInformation()
{
  this->Reset();
  const auto [file, name] = SplitPath(this->GetFileName());
  try
  {
    m_Dataset = std::make_unique<HDF5Dataset>(Choose(tissue::ListHDF5Datasets(file), name, m_PrefersIntegers));
  }
  catch (const std::runtime_error & error)
  {
    itkExceptionMacro(<< error.what());
  }
  const bool hasAxes = m_Dataset->axes.find('x') != std::string::npos &&
                       m_Dataset->axes.find('y') != std::string::npos && m_Dataset->axes.find('z') != std::string::npos;
  if (!hasAxes || ToComponentType(*m_Dataset) == IOComponentEnum::UNKNOWNCOMPONENTTYPE)
  {
    itkExceptionMacro("the data set " << m_Dataset->Describe() << " is no image of three dimensions");
  }
  if (!m_Dataset->missingFilter.empty())
  {
    itkExceptionMacro("the data set " << m_Dataset->name << " is compressed by " << m_Dataset->missingFilter
                                      << ", which this HDF5 has not: gzip can be read");
  }
  if (!m_Dataset->IsStored())
  {
    itkExceptionMacro("the data set " << m_Dataset->Describe() << " holds " << m_Dataset->storedBytes
                                      << " bytes in the file, which cannot be as many voxels");
  }
  const auto size = [this](char axis) { return static_cast<SizeValueType>(m_Dataset->SizeOf(axis)); };
  this->SetStack(
    { size('x'), size('y'), size('z') }, m_Dataset->voxelSize, m_Dataset->isInMicrometers, ToComponentType(*m_Dataset));
  this->RequireChoice(static_cast<unsigned int>(size('c')), static_cast<unsigned int>(size('t')));
}

void
StackHDF5ImageIO::Read(void * buffer)
{
  const ImageIORegion & io = this->GetIORegion();
  tissue::HDF5Region    region{ {}, { 1, 1, 1 }, this->ChosenChannel(), this->ChosenFrame() };
  for (unsigned int axis = 0; axis < std::min(3u, io.GetImageDimension()); ++axis)
  {
    region.begin[axis] = static_cast<std::size_t>(io.GetIndex(axis));
    region.size[axis] = static_cast<std::size_t>(io.GetSize(axis));
  }
  try
  {
    tissue::ReadHDF5Region(SplitPath(this->GetFileName()).first, *m_Dataset, region, static_cast<char *>(buffer));
  }
  catch (const std::runtime_error & error)
  {
    itkExceptionMacro(<< error.what());
  }
}
} // namespace itk
