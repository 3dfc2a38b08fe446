/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// Writes the label image of a synthetic tissue: SyntheticTissue [options] labels.mha

#include "Shared/CommandLine/OptionChecks.h"
#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/CommandLine/RunOptions.h"
#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Files/OutputFiles.h"
#include "Shared/Points/PointFileWriter.h"
#include "itkSyntheticNucleiImageFilter.h"
#include "itkSyntheticTissueImageSource.h"

#include <CLI/CLI.hpp>
#include <itkImageFileWriter.h>
#include <itkImageIOFactory.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

namespace
{
using Shape = itk::SyntheticTissueEnums::Shape;
using CellModel = itk::SyntheticTissueEnums::CellModel;

struct Options
{
  std::string                  labels;
  std::array<std::uint32_t, 3> size = { { 256, 256, 208 } };
  std::array<double, 3>        spacing = { { 1.0, 1.0, 1.0 } };
  std::uint32_t                cells = 1000;
  std::uint64_t                seed = 0;
  Shape                        shape = Shape::Dome;
  CellModel                    model = CellModel::Anisotropic;
  double                       anisotropy = 3.5;
  std::uint32_t                margin = 4;
  std::uint32_t                smoothing = 2;
  std::uint32_t                exteriorLabel = 0;
  std::uint32_t                firstLabel = 1;
  std::string                  pixelType = "uint16";
  std::string                  nuclei;
  std::string                  nucleiPoints;
  double                       signalToNoise = 5.0;
  bool                         compress = false;
  tissue::RunOptions           run;
};

/** Through a signed type: CLI11 would take -1 for the greatest number of an unsigned one. */
template <typename TInteger>
CLI::Range
UpTo()
{
  return { std::int64_t{ 0 }, static_cast<std::int64_t>(std::numeric_limits<TInteger>::max()) };
}

void
AddOptions(CLI::App & app, Options & options)
{
  const std::map<std::string, Shape>     shapes = { { "block", Shape::Block },
                                                    { "dome", Shape::Dome },
                                                    { "flower", Shape::Flower } };
  const std::map<std::string, CellModel> models = { { "voronoi", CellModel::Voronoi },
                                                    { "anisotropic", CellModel::Anisotropic },
                                                    { "division", CellModel::Division } };
  app.option_defaults()->always_capture_default();
  app.add_option("labels", options.labels, "Image to write, in any format of ITK for 3-D images")->required();
  app.add_option("--size", options.size, "Voxels along each axis")->check(CLI::Range(1, 100000));
  app.add_option("--spacing", options.spacing, "Size of a voxel")->check(CLI::Range(1e-6, 1e6));
  app.add_option("--cells", options.cells, "Number of cells")->check(CLI::Range(1, 100000000));
  app.add_option("--seed", options.seed, "Every seed gives another tissue")->check(UpTo<std::int64_t>());
  app.add_option("--shape", options.shape, "Outline of the tissue")
    ->transform(CLI::CheckedTransformer(shapes).description("{block,dome,flower}"))
    ->type_name("")
    ->default_str("dome");
  app.add_option("--model", options.model, "How the tissue is made into cells")
    ->transform(CLI::CheckedTransformer(models).description("{voronoi,anisotropic,division}"))
    ->type_name("")
    ->default_str("anisotropic");
  app.add_option("--anisotropy", options.anisotropy, "Greatest ratio of the axes of anisotropic cells")
    ->check(CLI::Range(1.0, 100.0));
  app.add_option("--margin", options.margin, "Voxels between the tissue and the border of the image")
    ->check(CLI::Range(0, 100000));
  app.add_option("--smoothing", options.smoothing, "Passes that smooth the walls")->check(CLI::Range(0, 100));
  app.add_option("--exteriorLabel", options.exteriorLabel, "Label of all that is not a cell")
    ->check(UpTo<std::uint32_t>());
  app.add_option("--firstLabel", options.firstLabel, "Label of the first cell; the exterior label is skipped")
    ->check(UpTo<std::uint32_t>());
  app.add_option("--pixelType", options.pixelType, "Type of the labels")
    ->check(CLI::IsMember({ "uint8", "uint16", "uint32" }));
  app.add_option("--nuclei", options.nuclei, "Also write an image like that of the cells' stained nuclei");
  app.add_option("--nucleiPoints", options.nucleiPoints, "Also write where the nuclei are: .csv, .fcsv or .vtp");
  app.add_option("--signalToNoise", options.signalToNoise, "Of the nuclei's image: signal of a nucleus over noise")
    ->check(CLI::Range(0.1, 100.0));
  app.add_flag("--compress", options.compress, "Compress the image");
  tissue::AddRunOptions(app, options.run);
}

/** The format by the file's extension; what ITK would find out too late, or not tell. */
itk::ImageIOBase::Pointer
MakeImageIO(const std::string & path)
{
  const auto io = itk::ImageIOFactory::CreateImageIO(path.c_str(), itk::IOFileModeEnum::WriteMode);
  if (io.IsNull())
  {
    throw std::runtime_error("Cannot write '" + path + "': ITK has no image format of this extension");
  }
  for (const char * extension : { ".mhd", ".nhdr", ".hdr", ".img" })
  {
    if (std::filesystem::path(path).extension() == extension)
    {
      throw std::runtime_error("Cannot write '" + path + "': the format is of two files, use .mha, .nrrd or .nii");
    }
  }
  return io;
}

template <typename TImage>
void
Write(const TImage * image, const std::string & path, bool compress)
{
  const auto io = MakeImageIO(path);
  const auto writer = itk::ImageFileWriter<TImage>::New();
  writer->SetInput(image);
  writer->SetImageIO(io);
  writer->SetFileName(path);
  writer->SetUseCompression(compress);
  try
  {
    writer->Update();
    // Formats of 2-D images write one slice, and do not complain.
    io->SetFileName(path);
    io->ReadImageInformation();
  }
  catch (const itk::ExceptionObject & error)
  {
    throw std::runtime_error(error.GetDescription());
  }
  const auto size = image->GetLargestPossibleRegion().GetSize();
  for (unsigned int i = 0; i < 3; ++i)
  {
    if ((i < io->GetNumberOfDimensions() ? io->GetDimensions(i) : 1) != size[i])
    {
      throw std::runtime_error("the format cannot hold a 3-D image");
    }
  }
}

template <typename TPixel>
TPixel
ToPixel(std::uint32_t label, const std::string & option)
{
  if (label > std::numeric_limits<TPixel>::max())
  {
    throw std::runtime_error(option + " is " + std::to_string(label) + ", but the pixel type holds at most " +
                             std::to_string(std::numeric_limits<TPixel>::max()));
  }
  return static_cast<TPixel>(label);
}

/** Nuclei by label, with their radii. */
template <typename TNuclei>
tissue::PointTable
ToTable(const TNuclei & nuclei)
{
  tissue::PointTable table;
  table.columns = { { "Label", {} }, { "radius", {} } };
  for (itk::SizeValueType i = 0; i < nuclei.GetNumberOfPoints(); ++i)
  {
    const auto point = nuclei.GetPoint(i);
    table.points.push_back({ { point[0], point[1], point[2] } });
    for (unsigned int c = 0; c < 2; ++c)
    {
      table.columns[c].second.push_back(nuclei.GetPointData()->GetElement(i)[c]);
    }
  }
  return table;
}

/** Throws for everything that would make the outputs impossible, before the work. */
void
RequireOutputs(const Options & options)
{
  for (const std::string & image : { options.labels, options.nuclei })
  {
    if (!image.empty())
    {
      MakeImageIO(image);
      tissue::OutputFiles::RequireWritable(image);
    }
  }
  if (!options.nucleiPoints.empty())
  {
    tissue::RequirePointFormat(options.nucleiPoints);
    tissue::OutputFiles::RequireWritable(options.nucleiPoints);
  }
}

template <typename TImage>
typename TImage::Pointer
MakeTissue(const Options & options, tissue::ProgressBar & progress)
{
  using PixelType = typename TImage::PixelType;
  const auto source = itk::SyntheticTissueImageSource<TImage>::New();
  source->SetSize(itk::Size<3>{ { options.size[0], options.size[1], options.size[2] } });
  source->SetSpacing(options.spacing.data());
  source->SetNumberOfCells(options.cells);
  source->SetSeed(options.seed);
  source->SetShape(options.shape);
  source->SetCellModel(options.model);
  source->SetAnisotropy(options.anisotropy);
  source->SetMargin(options.margin);
  source->SetSmoothing(options.smoothing);
  source->SetExteriorLabel(ToPixel<PixelType>(options.exteriorLabel, "--exteriorLabel"));
  source->SetFirstCellLabel(ToPixel<PixelType>(options.firstLabel, "--firstLabel"));
  progress.Begin("Growing cells");
  progress.Observe(source);
  source->Update();
  return source->GetOutput();
}

/** The filter, updated; null unless an image or the points of nuclei are asked for. */
template <typename TImage>
typename itk::SyntheticNucleiImageFilter<TImage>::Pointer
StainNuclei(const TImage * tissue, const Options & options, tissue::ProgressBar & progress)
{
  if (options.nuclei.empty() && options.nucleiPoints.empty())
  {
    return nullptr;
  }
  const auto nuclei = itk::SyntheticNucleiImageFilter<TImage>::New();
  nuclei->SetInput(tissue);
  nuclei->SetExteriorLabel(static_cast<typename TImage::PixelType>(options.exteriorLabel));
  nuclei->SetSignalToNoise(options.signalToNoise);
  nuclei->SetSeed(static_cast<std::uint32_t>(options.seed));
  progress.Begin("Staining nuclei");
  nuclei->Update();
  return nuclei;
}

template <typename TImage>
void
WriteOutputs(const TImage * tissue, itk::SyntheticNucleiImageFilter<TImage> * nuclei, const Options & options,
             tissue::ProgressBar & progress)
{
  progress.Begin("Writing");
  tissue::OutputFiles files;
  files.Add(options.labels, [&](const std::string & path) { Write(tissue, path, options.compress); });
  if (!options.nuclei.empty())
  {
    files.Add(options.nuclei, [&](const std::string & path) { Write(nuclei->GetOutput(), path, options.compress); });
  }
  if (!options.nucleiPoints.empty())
  {
    files.Add(options.nucleiPoints, [&](const std::string & path) {
      tissue::WritePoints(ToTable(*nuclei->GetNuclei()), path, tissue::RequirePointFormat(options.nucleiPoints));
    });
  }
  files.Commit();
  progress.End();
}

template <typename TPixel>
void
Run(const Options & options)
{
  using ImageType = itk::Image<TPixel, 3>;
  tissue::ProgressBar               progress(options.run.GetProgressStyle());
  const typename ImageType::Pointer tissue = MakeTissue<ImageType>(options, progress);
  const auto                        nuclei = StainNuclei<ImageType>(tissue, options, progress);
  WriteOutputs<ImageType>(tissue, nuclei, options, progress);
}

void
RunForPixelType(const Options & options)
{
  if (options.pixelType == "uint8")
  {
    Run<std::uint8_t>(options);
  }
  else if (options.pixelType == "uint16")
  {
    Run<std::uint16_t>(options);
  }
  else
  {
    Run<std::uint32_t>(options);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return tissue::RunProgram("SyntheticTissue", [&] {
    Options  options;
    CLI::App app("Writes a label image like that of a segmented plant tissue.");
    AddOptions(app, options);
    if (!tissue::Parse(app, argc, argv))
    {
      return;
    }
    RequireOutputs(options);
    tissue::UseThreads(options.run.threads);
    RunForPixelType(options);
    if (!options.run.isQuiet)
    {
      std::cout << options.labels << ": " << options.cells << " cells in " << options.size[0] << " x "
                << options.size[1] << " x " << options.size[2] << " voxels\n";
    }
  });
}
