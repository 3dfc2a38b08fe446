/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkExteriorLabelSettings_h
#define itkExteriorLabelSettings_h

#include "TissueTessellationCore/Common/Types.h"
#include "itkIndent.h"
#include "itkMacro.h"

#include <ostream>

namespace itk
{
/** \class ExteriorLabelSettings
 * \brief Which labels of an image are the exterior of the tissue, as the user says: what itkExteriorLabelMacro() sets.
 *
 * \ingroup TissueTessellation
 */
struct ExteriorLabelSettings
{
  tissue::Label label = 0;
  bool          isAutomatic = true;
  bool          zeroIsCell = false;

  /** Gives a filter that has the same settings these. */
  template <typename TFilter>
  void
  ApplyTo(TFilter * filter) const
  {
    filter->SetExteriorLabel(label);
    filter->SetAutomaticExteriorLabel(isAutomatic);
    filter->SetZeroIsCell(zeroIsCell);
  }

  void
  Print(std::ostream & os, Indent indent) const
  {
    os << indent << "ExteriorLabel: " << label << std::endl;
    os << indent << "AutomaticExteriorLabel: " << (isAutomatic ? "On" : "Off") << std::endl;
    os << indent << "ZeroIsCell: " << (zeroIsCell ? "On" : "Off") << std::endl;
  }
};
} // namespace itk

/** The settings of the exterior's label, of a class that keeps them as an itk::ExteriorLabelSettings in m_Exterior:
 *
 * - ExteriorLabel: the label of the exterior of the tissue. To set it turns AutomaticExteriorLabel off.
 * - AutomaticExteriorLabel: find that label by ExteriorLabelImageCalculator. Default: on.
 * - ZeroIsCell: take label 0 for a cell, if it is not the exterior label. Default: off. */
#define itkExteriorLabelMacro()                                                                                        \
  virtual void SetExteriorLabel(tissue::Label label)                                                                   \
  {                                                                                                                    \
    if (m_Exterior.label != label || m_Exterior.isAutomatic)                                                           \
    {                                                                                                                  \
      m_Exterior.label = label;                                                                                        \
      m_Exterior.isAutomatic = false;                                                                                  \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  virtual tissue::Label GetExteriorLabel() const                                                                       \
  {                                                                                                                    \
    return m_Exterior.label;                                                                                           \
  }                                                                                                                    \
  virtual void SetAutomaticExteriorLabel(bool isAutomatic)                                                             \
  {                                                                                                                    \
    if (m_Exterior.isAutomatic != isAutomatic)                                                                         \
    {                                                                                                                  \
      m_Exterior.isAutomatic = isAutomatic;                                                                            \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  virtual bool GetAutomaticExteriorLabel() const                                                                       \
  {                                                                                                                    \
    return m_Exterior.isAutomatic;                                                                                     \
  }                                                                                                                    \
  itkBooleanMacro(AutomaticExteriorLabel);                                                                             \
  virtual void SetZeroIsCell(bool zeroIsCell)                                                                          \
  {                                                                                                                    \
    if (m_Exterior.zeroIsCell != zeroIsCell)                                                                           \
    {                                                                                                                  \
      m_Exterior.zeroIsCell = zeroIsCell;                                                                              \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  virtual bool GetZeroIsCell() const                                                                                   \
  {                                                                                                                    \
    return m_Exterior.zeroIsCell;                                                                                      \
  }                                                                                                                    \
  itkBooleanMacro(ZeroIsCell)

#endif
