/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "NucleiTessellation/PointBox.h"

#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Images/ImageInput.h"
#include "Shared/Points/PointFileReader.h"

#include <algorithm>

namespace tissue
{
itk::ImageBase<3>::Pointer
FindBox(const CenterOptions & options, TissueInput & input)
{
  const bool        isOfImage = !options.centersOf.empty() || !IsPointFile(options.file);
  const bool        isOther = !options.box.empty();
  const std::string path = isOther || !isOfImage ? options.box : options.Source();
  if (path.empty())
  {
    return nullptr;
  }
  return WithFileName(path, [&] {
    ImageOptions imageOptions = isOther && isOfImage ? options.image.ForFurther() : options.image;
    imageOptions.channel = std::max(1u, imageOptions.channel);
    imageOptions.frame = std::max(1u, imageOptions.frame);
    const auto io = OpenImage(path, imageOptions, options.centersOf.empty() ? ImageKind::Stain : ImageKind::Labels);
    RequireVolume(io, "an image of a tissue");
    const auto box = ReadBox(io, imageOptions);
    if (isOther)
    {
      for (const std::string & warning : FindHeaderWarnings(io, imageOptions))
      {
        input.warnings.push_back(path + ": " + warning);
      }
      input.image.unit = FindUnit(io, imageOptions);
    }
    return box;
  });
}
} // namespace tissue
