/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef LabelImageFromText_h
#define LabelImageFromText_h

#include "itkImage.h"

#include <string>
#include <vector>

/** Label images as text, for tests whose images are to be seen. */
namespace tissue_test
{
using TextImageType = itk::Image<unsigned char, 3>;

/** An image of one layer for each string, its rows separated by '/', its labels the characters. */
inline TextImageType::Pointer
LabelImageFromText(const std::vector<std::string> & layers)
{
  const std::size_t rowSize =
    layers.front().find('/') == std::string::npos ? layers.front().size() : layers.front().find('/');
  const std::size_t rows = (layers.front().size() + 1) / (rowSize + 1);
  auto              image = TextImageType::New();
  image->SetRegions(TextImageType::SizeType{ { rowSize, rows, layers.size() } });
  image->Allocate();
  unsigned char * voxel = image->GetBufferPointer();
  for (const std::string & layer : layers)
  {
    for (const char label : layer)
    {
      if (label != '/')
      {
        *voxel++ = static_cast<unsigned char>(label);
      }
    }
  }
  return image;
}

/** The reverse. */
inline std::vector<std::string>
TextFromLabelImage(const TextImageType * image)
{
  const auto               size = image->GetBufferedRegion().GetSize();
  const unsigned char *    voxel = image->GetBufferPointer();
  std::vector<std::string> layers(size[2]);
  for (std::string & layer : layers)
  {
    for (std::size_t y = 0; y < size[1]; ++y)
    {
      layer += y > 0 ? "/" : "";
      layer.append(voxel, voxel + size[0]);
      voxel += size[0];
    }
  }
  return layers;
}
} // namespace tissue_test

#endif
