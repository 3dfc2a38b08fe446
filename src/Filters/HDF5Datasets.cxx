/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "HDF5Datasets.h"

#include "HDF5Handles.h"
#include "LengthUnit.h"

#include <algorithm>
#include <cstring>
#include <regex>
#include <stdexcept>

namespace tissue
{
namespace
{
/** An attribute of text, of fixed or variable length; empty where there is none. */
std::string
ReadText(hid_t object, const char * name)
{
  const HDF5Identifier attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  if (attribute < 0)
  {
    return {};
  }
  const HDF5Identifier type(H5Aget_type(attribute), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING)
  {
    return {};
  }
  if (H5Tis_variable_str(type) > 0)
  {
    char *               text = nullptr;
    const HDF5Identifier memory(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(memory, H5T_VARIABLE);
    H5Tset_cset(memory, H5Tget_cset(type));
    std::string result;
    if (H5Aread(attribute, memory, &text) >= 0 && text != nullptr)
    {
      result = text;
      H5free_memory(text);
    }
    return result;
  }
  std::string text(H5Tget_size(type), '\0');
  return H5Aread(attribute, type, text.data()) >= 0 ? std::string(text.c_str()) : std::string();
}

/** An attribute of three numbers; empty where there is none. */
std::vector<double>
ReadThreeNumbers(hid_t object, const char * name)
{
  const HDF5Identifier attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  if (attribute < 0)
  {
    return {};
  }
  const HDF5Identifier space(H5Aget_space(attribute), H5Sclose);
  std::vector<double>  numbers(3);
  const bool           isRead =
    H5Sget_simple_extent_npoints(space) == 3 && H5Aread(attribute, H5T_NATIVE_DOUBLE, numbers.data()) >= 0;
  return isRead ? numbers : std::vector<double>();
}

/** The axes of a set without names for them. */
std::string
GuessAxes(const std::vector<std::size_t> & shape)
{
  std::vector<std::size_t> longAxes;
  for (std::size_t i = 0; i < shape.size(); ++i)
  {
    if (shape[i] > 1)
    {
      longAxes.push_back(i);
    }
  }
  std::string axes(shape.size(), '1');
  std::string names = longAxes.size() == 4 ? "czyx" : longAxes.size() == 5 ? "tczyx" : "zyx";
  if (longAxes.size() == 4 && shape[longAxes[3]] <= 4 && shape[longAxes[3]] < shape[longAxes[0]])
  {
    names = "zyxc";
  }
  if (longAxes.size() < 3 && shape.size() >= 3)
  {
    longAxes = { shape.size() - 3, shape.size() - 2, shape.size() - 1 };
  }
  for (std::size_t i = 0; longAxes.size() == names.size() && i < names.size(); ++i)
  {
    axes[longAxes[i]] = names[i];
  }
  return axes;
}

/** What axistags tells, {"axes": [{"key": "z", "resolution": 0.9, ...}, ...]}, with the units of axis_units. */
void
ReadAxisTags(hid_t object, HDF5Dataset & dataset)
{
  static const std::regex tag(R"(\{[^{}]*\"key\"\s*:\s*\"(\w)\"[^{}]*\})");
  static const std::regex resolution(R"(\"resolution\"\s*:\s*([-+.\deE]+))");
  const std::string       tags = ReadText(object, "axistags");
  const std::string       units = ReadText(object, "axis_units");
  std::string             axes;
  for (std::sregex_iterator match(tags.begin(), tags.end(), tag), end; match != end; ++match)
  {
    const char        axis = (*match)[1].str()[0];
    const std::size_t index = std::string("xyz").find(axis);
    const std::string text = match->str();
    std::smatch       length;
    axes += std::string("xyzct").find(axis) != std::string::npos ? axis : '1';
    if (index < 3 && std::regex_search(text, length, resolution))
    {
      std::smatch      unit;
      const std::regex ofAxis(std::string(1, '"') + axis + R"re("\s*:\s*"([^"]*)")re");
      const auto   micrometers = std::regex_search(units, unit, ofAxis) ? ToMicrometers(unit[1].str()) : std::nullopt;
      const double size = std::strtod(length[1].str().c_str(), nullptr);
      dataset.voxelSize[index] = size > 0.0 ? std::optional<double>(size * micrometers.value_or(1.0)) : std::nullopt;
      dataset.isInMicrometers = dataset.isInMicrometers || micrometers.has_value();
    }
  }
  dataset.axes = axes.size() == dataset.shape.size() ? axes : GuessAxes(dataset.shape);
}

std::string
FindMissingFilter(hid_t object)
{
  const HDF5Identifier creation(H5Dget_create_plist(object), H5Pclose);
  for (int i = 0; i < H5Pget_nfilters(creation); ++i)
  {
    char               name[64] = "";
    unsigned int       flags = 0;
    std::size_t        numberOfValues = 0;
    const H5Z_filter_t filter = H5Pget_filter2(
      creation, static_cast<unsigned int>(i), &flags, &numberOfValues, nullptr, sizeof(name), name, nullptr);
    if (H5Zfilter_avail(filter) <= 0)
    {
      return *name != '\0' ? name : std::to_string(filter);
    }
  }
  return {};
}

/** False where it holds no numbers. */
bool
ReadDataset(hid_t file, hid_t object, HDF5Dataset & dataset)
{
  const HDF5Identifier type(H5Dget_type(object), H5Tclose);
  const H5T_class_t    typeClass = H5Tget_class(type);
  const HDF5Identifier space(H5Dget_space(object), H5Sclose);
  const int            dimensions = H5Sget_simple_extent_ndims(space);
  if ((typeClass != H5T_INTEGER && typeClass != H5T_FLOAT) || dimensions < 1)
  {
    return false;
  }
  std::vector<hsize_t> sizes(static_cast<std::size_t>(dimensions));
  H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
  dataset.shape.assign(sizes.begin(), sizes.end());
  dataset.kind = typeClass == H5T_FLOAT ? 'f' : H5Tget_sign(type) == H5T_SGN_NONE ? 'u' : 'i';
  dataset.bytes = H5Tget_size(type);
  // Floats of half and of extended precision are read as what there is nearest to them.
  dataset.bytes = dataset.kind == 'f' ? (dataset.bytes > 4 ? 8 : 4) : dataset.bytes;
  ReadAxisTags(object, dataset);
  std::vector<double> sizeInMicrometers = ReadThreeNumbers(object, "element_size_um");
  if (sizeInMicrometers.empty())
  {
    sizeInMicrometers = ReadThreeNumbers(file, "element_size_um");
  }
  if (!sizeInMicrometers.empty())
  {
    dataset.voxelSize = { sizeInMicrometers[2], sizeInMicrometers[1], sizeInMicrometers[0] };
    dataset.isInMicrometers = true;
  }
  dataset.missingFilter = FindMissingFilter(object);
  dataset.storedBytes = H5Dget_storage_size(object);
  return true;
}

struct Visit
{
  hid_t                      file;
  std::vector<HDF5Dataset> * datasets;
};

herr_t
VisitLink(hid_t group, const char * name, const H5L_info_t *, void * data)
{
  const auto &         visit = *static_cast<const Visit *>(data);
  const HDF5Identifier object(H5Oopen(group, name, H5P_DEFAULT), H5Oclose);
  HDF5Dataset          dataset;
  dataset.name = std::string("/") + name;
  if (object >= 0 && H5Iget_type(object) == H5I_DATASET && ReadDataset(visit.file, object, dataset))
  {
    visit.datasets->push_back(dataset);
  }
  return 0;
}

hid_t
NativeType(const HDF5Dataset & dataset)
{
  const bool isSigned = dataset.kind == 'i';
  if (dataset.kind == 'f')
  {
    return dataset.bytes == 4 ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE;
  }
  switch (dataset.bytes)
  {
    case 1:
      return isSigned ? H5T_NATIVE_INT8 : H5T_NATIVE_UINT8;
    case 2:
      return isSigned ? H5T_NATIVE_INT16 : H5T_NATIVE_UINT16;
    case 4:
      return isSigned ? H5T_NATIVE_INT32 : H5T_NATIVE_UINT32;
    default:
      return isSigned ? H5T_NATIVE_INT64 : H5T_NATIVE_UINT64;
  }
}

/** Copies pixels whose axes are in another order than z, y, x. \param order "xyz" where x is the slowest. */
void
Permute(const std::vector<char> & from, const std::string & order, const std::array<std::size_t, 3> & size,
        std::size_t bytes, char * to)
{
  std::array<std::size_t, 3> step{};
  std::size_t                total = bytes;
  for (std::size_t i = order.size(); i-- > 0;)
  {
    const std::size_t axis = std::string("xyz").find(order[i]);
    step[axis] = total;
    total *= size[axis];
  }
  for (std::size_t z = 0; z < size[2]; ++z)
  {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      for (std::size_t x = 0; x < size[0]; ++x, to += bytes)
      {
        std::memcpy(to, from.data() + x * step[0] + y * step[1] + z * step[2], bytes);
      }
    }
  }
}
} // namespace

std::size_t
HDF5Dataset::SizeOf(char axis) const
{
  const std::size_t at = axes.find(axis);
  return at != std::string::npos ? shape[at] : 1;
}

bool
HDF5Dataset::IsVolume() const
{
  return this->SizeOf('x') > 1 && this->SizeOf('y') > 1 && this->SizeOf('z') > 1;
}

bool
HDF5Dataset::IsStored() const
{
  constexpr double most = 1e6;
  double           total = static_cast<double>(bytes);
  for (const std::size_t size : shape)
  {
    total *= static_cast<double>(size);
  }
  return total <= most * static_cast<double>(storedBytes);
}

std::string
HDF5Dataset::Describe() const
{
  std::string text = name + " (";
  for (const std::size_t size : shape)
  {
    text += std::to_string(size) + " x ";
  }
  text.resize(text.size() - 3);
  const std::string kindName = kind == 'f' ? "float" : kind == 'u' ? "uint" : "int";
  return text + ", " + kindName + std::to_string(8 * bytes) + ")";
}

std::vector<HDF5Dataset>
ListHDF5Datasets(const std::string & file)
{
  const HDF5Silence    silence;
  const HDF5Identifier opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (opened < 0)
  {
    throw std::runtime_error("the file is no HDF5, or cut off or broken");
  }
  std::vector<HDF5Dataset> datasets;
  Visit                    visit{ opened, &datasets };
  H5Lvisit(opened, H5_INDEX_NAME, H5_ITER_INC, VisitLink, &visit);
  return datasets;
}

void
ReadHDF5Region(const std::string & file, const HDF5Dataset & dataset, const HDF5Region & region, char * pixels)
{
  const HDF5Silence    silence;
  const std::string    spatial = "xyz";
  std::vector<hsize_t> begin;
  std::vector<hsize_t> size;
  std::string          order;
  for (const char axis : dataset.axes)
  {
    const std::size_t index = spatial.find(axis);
    begin.push_back(index < 3 ? region.begin[index] : axis == 'c' ? region.channel : axis == 't' ? region.frame : 0);
    size.push_back(index < 3 ? region.size[index] : 1);
    order += index < 3 ? std::string(1, axis) : "";
  }
  const HDF5Identifier opened(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const HDF5Identifier object(H5Dopen2(opened, dataset.name.c_str(), H5P_DEFAULT), H5Dclose);
  const HDF5Identifier space(H5Dget_space(object), H5Sclose);
  const HDF5Identifier memory(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose);
  const bool           isInOrder = order == "zyx";
  const std::size_t    number = region.size[0] * region.size[1] * region.size[2];
  std::vector<char>    other(isInOrder ? 0 : number * dataset.bytes);
  if (H5Sselect_hyperslab(space, H5S_SELECT_SET, begin.data(), nullptr, size.data(), nullptr) < 0 ||
      H5Dread(object, NativeType(dataset), memory, space, H5P_DEFAULT, isInOrder ? pixels : other.data()) < 0)
  {
    throw std::runtime_error("the data set " + dataset.name + " cannot be read: the file is cut off or broken");
  }
  if (!isInOrder)
  {
    Permute(other, order, region.size, dataset.bytes, pixels);
  }
}
} // namespace tissue
