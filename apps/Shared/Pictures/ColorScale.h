/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ColorScale_h
#define ColorScale_h

#include "Shared/Pictures/CellColors.h"

#include <vtkLookupTable.h>
#include <vtkNew.h>

#include <string>
#include <vector>

namespace tissue
{
/** Values that cells are coloured by. */
struct PictureValues
{
  /** Their name, with the unit, UTF-8. */
  std::string title;
  /** Of each vertex: numbers, which are not a number where none is known, or else texts, empty likewise. */
  std::vector<double>      numbers;
  std::vector<std::string> texts;
};

/** \brief Colours for values, told apart by the colour-blind as well, and a table of them for a legend.
 *
 * Texts, and whole numbers of which there are at most seven, are categories, with colours of M. Okabe and K. Ito (Color
 * Universal Design, 2008), the numbers ascending, the texts by how many cells have them; of more texts all but the six
 * that most cells have are "others". Other numbers go from the dark to the light end of the map viridis, from the 2nd
 * to the 98th percentile: what is beyond has the colour of the end. What is not known is grey. */
class ColorScale
{
public:
  explicit ColorScale(const PictureValues & values);

  /** Of each vertex. */
  const std::vector<Color> &
  GetColors() const
  {
    return m_Colors;
  }

  /** Whose annotations are the categories, if the values are such. */
  vtkLookupTable *
  GetTable() const
  {
    return m_Table;
  }

  bool
  IsOfCategories() const
  {
    return m_IsOfCategories;
  }

  /** What is to be said of the range, behind the title. */
  std::string
  GetNote() const
  {
    return m_IsOfCategories ? "" : ", 2nd to 98th percentile";
  }

  /** Whether a cell has a value that is not known. */
  bool
  HasUnknown() const
  {
    return m_HasUnknown;
  }

private:
  void
  SetCategories(const std::vector<std::string> & names);

  void
  SetRange(const std::vector<double> & numbers);

  std::vector<Color>     m_Colors;
  vtkNew<vtkLookupTable> m_Table;
  bool                   m_IsOfCategories = false;
  bool                   m_HasUnknown = false;
};
} // namespace tissue

#endif
