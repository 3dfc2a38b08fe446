/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationProgramTest.h"

#include <itkGiplImageIO.h>
#include <itkImageFileWriter.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <itkTIFFImageIO.h>
#include <itkVTKImageIO.h>
#include <sys/wait.h>

#include <cstdlib>

namespace
{
itk::ImageIOBase::Pointer
MakeImageIO(const std::string & name)
{
  const auto endsIn = [&name](const std::string & end) {
    return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  };
  if (endsIn(".nrrd"))
  {
    return itk::NrrdImageIO::New().GetPointer();
  }
  if (endsIn(".nii") || endsIn(".nii.gz"))
  {
    return itk::NiftiImageIO::New().GetPointer();
  }
  if (endsIn(".tif"))
  {
    return itk::TIFFImageIO::New().GetPointer();
  }
  if (endsIn(".vtk"))
  {
    return itk::VTKImageIO::New().GetPointer();
  }
  if (endsIn(".gipl"))
  {
    return itk::GiplImageIO::New().GetPointer();
  }
  return itk::MetaImageIO::New().GetPointer();
}
} // namespace

int
TissueTessellationAppTest::Run(const std::string & arguments, const std::string & before)
{
  const std::string command =
    "cd " + m_Folder.string() + " && " + before + " " + m_Program + " " + arguments + " > out.txt 2> err.txt";
  const int status = std::system(command.c_str());
  m_Output = ReadBytes(this->PathOf("out.txt"));
  m_Errors = ReadBytes(this->PathOf("err.txt"));
  std::filesystem::remove(this->PathOf("out.txt"));
  std::filesystem::remove(this->PathOf("err.txt"));
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

template <typename TImage>
void
TissueTessellationAppTest::WriteImage(const TImage * image, const std::string & name, bool isCompressed)
{
  const auto writer = itk::ImageFileWriter<TImage>::New();
  const auto io = MakeImageIO(name);
  // Binary where there is a choice: VTK's default is text.
  io->SetFileTypeToBinary();
  writer->SetImageIO(io);
  writer->SetInput(image);
  writer->SetFileName(this->PathOf(name));
  writer->SetUseCompression(isCompressed);
  writer->Update();
}

template <typename TPixel>
void
TissueTessellationAppTest::WriteTissue(const std::string & name, bool isCompressed)
{
  this->WriteImage(MakeSyntheticTestTissue<TPixel>().GetPointer(), name, isCompressed);
}

nlohmann::json
TissueTessellationAppTest::ReadReport() const
{
  return nlohmann::json::parse(ReadBytes(this->PathOf("report.json")));
}

nlohmann::json
TissueTessellationAppTest::RunAndReport(const std::string & arguments)
{
  EXPECT_EQ(this->Run(arguments + " --report report.json"), 0) << arguments << ": " << m_Errors;
  return this->ReadReport();
}

std::set<long>
TissueTessellationAppTest::LabelsOf(const nlohmann::json & report, const std::string & reason)
{
  std::set<long> labels;
  for (const nlohmann::json & remark : report["remarks"])
  {
    if (remark["reason"] == reason)
    {
      labels.insert(remark["label"].get<long>());
    }
  }
  return labels;
}

void
TissueTessellationAppTest::ExpectRefusal(const std::string & arguments, const std::vector<std::string> & parts,
                                         const std::string & before)
{
  const std::string files = this->List();
  EXPECT_EQ(this->Run(arguments, before), 1) << arguments;
  EXPECT_EQ(m_Output, "") << arguments;
  EXPECT_EQ(m_Errors.find(std::filesystem::path(m_Program).filename().string() + ": "), 0u)
    << arguments << ": " << m_Errors;
  EXPECT_EQ(m_Errors.find('\n'), m_Errors.size() - 1) << arguments << ": " << m_Errors;
  for (const std::string & part : parts)
  {
    EXPECT_NE(m_Errors.find(part), std::string::npos) << arguments << ": '" << part << "' is not in " << m_Errors;
  }
  for (const char * noise : { "ITK ERROR", "0x", ".cxx", ".hxx" })
  {
    EXPECT_EQ(m_Errors.find(noise), std::string::npos) << arguments << ": " << m_Errors;
  }
  EXPECT_EQ(this->List(), files) << arguments;
}

#define WRITE_IMAGE(...)                                                                                               \
  template void TissueTessellationAppTest::WriteImage(const __VA_ARGS__ *, const std::string &, bool)
#define WRITE_TISSUE(pixel)                                                                                            \
  WRITE_IMAGE(itk::Image<pixel, 3>);                                                                                   \
  template void TissueTessellationAppTest::WriteTissue<pixel>(const std::string &, bool)
WRITE_TISSUE(signed char);
WRITE_TISSUE(unsigned char);
WRITE_TISSUE(short);
WRITE_TISSUE(unsigned short);
WRITE_TISSUE(int);
WRITE_TISSUE(unsigned int);
WRITE_TISSUE(long long);
WRITE_TISSUE(unsigned long long);
WRITE_IMAGE(itk::Image<float, 3>);
WRITE_IMAGE(itk::Image<unsigned char, 2>);
WRITE_IMAGE(itk::Image<float, 2>);
WRITE_IMAGE(itk::Image<unsigned short, 4>);
WRITE_IMAGE(itk::Image<itk::Vector<unsigned char, 3>, 3>);
WRITE_IMAGE(itk::Image<itk::Vector<unsigned short, 2>, 3>);
