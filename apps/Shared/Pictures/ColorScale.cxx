/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Pictures/ColorScale.h"

#include <vtkColorTransferFunction.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace tissue
{
namespace
{
constexpr std::size_t mostCategories = 7;
/** Of Okabe and Ito, without black, as outlines are. */
constexpr unsigned char categoryColors[mostCategories][3] = { { 0, 114, 178 },   { 230, 159, 0 },  { 0, 158, 115 },
                                                              { 204, 121, 167 }, { 86, 180, 233 }, { 213, 94, 0 },
                                                              { 240, 228, 66 } };
/** Of viridis, every tenth of it (S. van der Walt and N. Smith, for matplotlib; CC0). */
constexpr unsigned char viridis[][3] = { { 68, 1, 84 },    { 72, 36, 117 },  { 65, 68, 135 },  { 53, 95, 141 },
                                         { 42, 120, 142 }, { 33, 145, 140 }, { 34, 168, 132 }, { 68, 191, 112 },
                                         { 122, 209, 81 }, { 189, 223, 38 }, { 253, 231, 37 } };
constexpr unsigned char unknownColor[3] = { 178, 178, 178 };
constexpr double        unknown = std::numeric_limits<double>::quiet_NaN();

/** The values of the cells that are known, ascending. */
std::vector<double>
SortKnown(const std::vector<double> & numbers)
{
  std::vector<double> known;
  for (std::size_t v = ExteriorVertex + 1; v < numbers.size(); ++v)
  {
    if (std::isfinite(numbers[v]))
    {
      known.push_back(numbers[v]);
    }
  }
  std::sort(known.begin(), known.end());
  return known;
}

/** Between the values that are next to it. */
double
PercentileOf(const std::vector<double> & sorted, double percent)
{
  const double      at = percent / 100.0 * static_cast<double>(sorted.size() - 1);
  const std::size_t low = static_cast<std::size_t>(at);
  const std::size_t high = std::min(low + 1, sorted.size() - 1);
  return sorted[low] + (at - static_cast<double>(low)) * (sorted[high] - sorted[low]);
}

std::string
ToText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

/** The texts as indices of the names, of which there are as many as colours at most. */
std::vector<double>
CountTexts(const std::vector<std::string> & texts, std::vector<std::string> & names)
{
  std::map<std::string, std::size_t> counts;
  for (std::size_t v = ExteriorVertex + 1; v < texts.size(); ++v)
  {
    counts[texts[v]] += texts[v].empty() ? 0 : 1;
  }
  counts.erase("");
  for (const auto & [text, count] : counts)
  {
    names.push_back(text);
  }
  std::stable_sort(names.begin(), names.end(), [&counts](const std::string & a, const std::string & b) {
    return counts[a] > counts[b];
  });
  std::map<std::string, double> indexOf;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const std::size_t last = names.size() > mostCategories ? mostCategories - 1 : i;
    indexOf[names[i]] = static_cast<double>(std::min(i, last));
  }
  if (names.size() > mostCategories)
  {
    names.resize(mostCategories - 1);
    names.emplace_back("others");
  }
  std::vector<double> indices;
  for (const std::string & text : texts)
  {
    indices.push_back(text.empty() ? unknown : indexOf.at(text));
  }
  return indices;
}

/** The numbers as indices of the names, if they are whole and few; else nothing. */
std::vector<double>
CountNumbers(const std::vector<double> & numbers, std::vector<std::string> & names)
{
  const std::vector<double> known = SortKnown(numbers);
  const std::set<double>    different(known.begin(), known.end());
  const bool                areWhole =
    std::all_of(different.begin(), different.end(), [](double number) { return number == std::floor(number); });
  if (!areWhole || different.empty() || different.size() > mostCategories)
  {
    return {};
  }
  std::transform(different.begin(), different.end(), std::back_inserter(names), ToText);
  std::vector<double> indices;
  for (const double number : numbers)
  {
    // What is no number is none of them, though a set finds it.
    const auto at = std::isfinite(number) ? different.find(number) : different.end();
    indices.push_back(at == different.end() ? unknown : static_cast<double>(std::distance(different.begin(), at)));
  }
  return indices;
}
} // namespace

ColorScale::ColorScale(const PictureValues & values)
{
  std::vector<std::string> names;
  std::vector<double>      indices =
    values.texts.empty() ? CountNumbers(values.numbers, names) : CountTexts(values.texts, names);
  m_Table->SetNanColor(unknownColor[0] / 255.0, unknownColor[1] / 255.0, unknownColor[2] / 255.0, 1.0);
  m_IsOfCategories = !names.empty();
  m_IsOfCategories ? this->SetCategories(names) : this->SetRange(values.numbers);
  const std::vector<double> & numbers = m_IsOfCategories ? indices : values.numbers;
  for (std::size_t v = 0; v < numbers.size(); ++v)
  {
    const bool                  isKnown = std::isfinite(numbers[v]);
    const unsigned char * const color = isKnown ? m_Table->MapValue(numbers[v]) : unknownColor;
    m_Colors.push_back({ { color[0], color[1], color[2] } });
    m_HasUnknown = m_HasUnknown || (!isKnown && v > ExteriorVertex);
  }
}

void
ColorScale::SetCategories(const std::vector<std::string> & names)
{
  m_Table->IndexedLookupOn();
  m_Table->SetNumberOfTableValues(static_cast<vtkIdType>(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const unsigned char * const color = categoryColors[i];
    m_Table->SetAnnotation(vtkVariant(static_cast<double>(i)), names[i]);
    m_Table->SetTableValue(static_cast<vtkIdType>(i), color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  }
}

void
ColorScale::SetRange(const std::vector<double> & numbers)
{
  constexpr int                          numberOfColors = 256;
  const std::vector<double>              known = SortKnown(numbers);
  const vtkNew<vtkColorTransferFunction> map;
  map->SetColorSpaceToLab();
  const auto count = static_cast<double>(std::size(viridis) - 1);
  for (std::size_t i = 0; i < std::size(viridis); ++i)
  {
    const unsigned char * const color = viridis[i];
    map->AddRGBPoint(static_cast<double>(i) / count, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  }
  m_Table->SetNumberOfTableValues(numberOfColors);
  for (int i = 0; i < numberOfColors; ++i)
  {
    double color[3];
    map->GetColor(i / (numberOfColors - 1.0), color);
    m_Table->SetTableValue(i, color[0], color[1], color[2]);
  }
  double low = known.empty() ? 0.0 : PercentileOf(known, 2.0);
  double high = known.empty() ? 1.0 : PercentileOf(known, 98.0);
  if (!(low < high))
  {
    const double half = low == 0.0 ? 0.5 : 0.5 * std::abs(low);
    low -= half;
    high += half;
  }
  m_Table->SetTableRange(low, high);
}
} // namespace tissue
