/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TIFFPages_h
#define TIFFPages_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tissue
{
/** What the pixels of a page of a TIFF file are. */
struct TIFFPageFormat
{
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint16_t bits = 1;
  /** As SAMPLEFORMAT_UINT of libtiff. */
  std::uint16_t sampleFormat = 1;
  std::uint16_t numberOfSamples = 1;
  /** As PHOTOMETRIC_PALETTE of libtiff. */
  std::uint16_t photometric = 1;
  /** Whether the samples are planes of their own. */
  bool isPlanar = false;

  bool
  operator==(const TIFFPageFormat & other) const;
};

/** \class TIFFPages
 * \brief The pages of a TIFF file, read by libtiff: strips and tiles, any compression that libtiff has, both byte
 * orders, and files above 4 GiB.
 *
 * Pages of lesser resolution (previews, pyramids) are not counted. Palettes are not applied: the indices are the
 * pixels. Where libtiff complains, its words are in the message of the exception; its warnings are dropped, as tags of
 * private kind are many in these files. */
class TIFFPages
{
public:
  /** \throws std::runtime_error: not a TIFF file, cut off, or broken. */
  explicit TIFFPages(const std::string & path);
  ~TIFFPages();
  TIFFPages(const TIFFPages &) = delete;
  TIFFPages &
  operator=(const TIFFPages &) = delete;

  /** By its first bytes. */
  static bool
  IsTIFF(const std::string & path);

  std::size_t
  GetNumberOfPages() const
  {
    return m_Pages.size();
  }
  const TIFFPageFormat &
  GetFormat(std::size_t page) const
  {
    return m_Pages[page].format;
  }

  /** Of the first page, as are the others: tag ImageDescription. */
  const std::string &
  GetDescription() const
  {
    return m_Description;
  }
  /** Tag Software. */
  const std::string &
  GetSoftware() const
  {
    return m_Software;
  }
  /** Pixels a unit along x and y, 0 where the file has none. */
  const std::array<double, 2> &
  GetResolution() const
  {
    return m_Resolution;
  }
  /** Tag ResolutionUnit: 1 none, 2 inch, 3 centimetre. */
  std::uint16_t
  GetResolutionUnit() const
  {
    return m_ResolutionUnit;
  }

  /** \brief Whether a file of one page holds the pixels of that many right behind one another, without pages.
   *
   * ImageJ writes stacks above 4 GiB so, tifffile where it is told to. From a true answer on these are its pages. */
  bool
  SplitSinglePage(std::size_t numberOfPages);

  /** Reads one sample of each pixel of a page, the rows behind one another, in the machine's byte order. Pixels of less
   * than a byte become bytes.
   * \param pixels room for width * height pixels.
   * \throws std::runtime_error where the page cannot be decoded. */
  void
  ReadPage(std::size_t page, std::size_t sample, char * pixels);

private:
  struct Page
  {
    std::uint64_t  offset;
    TIFFPageFormat format;
  };
  /** What libtiff said last, and its file. */
  struct Handle;

  void
  ReadDirectories();
  void
  ReadFirstTags();
  void
  ReadTiles(const TIFFPageFormat & format, std::size_t sample, char * pixels);
  void
  ReadStrips(const TIFFPageFormat & format, std::size_t sample, char * pixels);
  void
  ReadRaw(std::size_t page, char * pixels);
  [[noreturn]] void
  Fail(const std::string & what) const;

  std::string             m_Path;
  std::unique_ptr<Handle> m_Handle;
  std::vector<Page>       m_Pages;
  std::string             m_Description;
  std::string             m_Software;
  std::array<double, 2>   m_Resolution{};
  std::uint16_t           m_ResolutionUnit = 2;
  /** Of the pixels of the first page in the file, where pages are split from it; 0 otherwise. */
  std::uint64_t m_RawOffset = 0;
};
} // namespace tissue

#endif
