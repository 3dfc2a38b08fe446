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

#include <algorithm>
#include <ostream>
#include <vector>

namespace itk
{
/** \class ExteriorLabelSettings
 * \brief Which labels of an image are the exterior of the tissue, as the user says: what itkExteriorLabelMacro() sets.
 *
 * \ingroup TissueTessellation
 */
struct ExteriorLabelSettings
{
  /** None twice; the first one stands for the exterior. They mean nothing where isAutomatic is set. */
  std::vector<tissue::Label> labels;
  bool                       isAutomatic = true;
  bool                       zeroIsCell = false;
  /** None twice. */
  std::vector<tissue::Label> dropped;
  bool                       dropsSuspects = false;

  /** Adds the label to one of the lists; false where it is there already. */
  static bool
  Add(tissue::Label label, std::vector<tissue::Label> & list)
  {
    const bool isNew = std::find(list.begin(), list.end(), label) == list.end();
    if (isNew)
    {
      list.push_back(label);
    }
    return isNew;
  }

  void
  Print(std::ostream & os, Indent indent) const
  {
    const auto print = [&](const char * name, const std::vector<tissue::Label> & list) {
      os << indent << name << ":";
      for (const tissue::Label label : list)
      {
        os << ' ' << label;
      }
      os << std::endl;
    };
    print("ExteriorLabels", labels);
    os << indent << "AutomaticExteriorLabel: " << (isAutomatic ? "On" : "Off") << std::endl;
    os << indent << "ZeroIsCell: " << (zeroIsCell ? "On" : "Off") << std::endl;
    print("DroppedLabels", dropped);
    os << indent << "DropSuspects: " << (dropsSuspects ? "On" : "Off") << std::endl;
  }
};
} // namespace itk

/** The settings of the exterior's labels, of a class that keeps them as an itk::ExteriorLabelSettings in m_Exterior:
 *
 * - ExteriorLabel: the label of the exterior of the tissue. To set it turns AutomaticExteriorLabel off. By
 *   AddExteriorLabel() there are several, which are one exterior; the first one stands for it. GetExteriorLabel() is 0
 *   where none was set.
 * - AutomaticExteriorLabel: find the labels by ExteriorLabelImageCalculator. Default: on.
 * - ZeroIsCell: take label 0 for a cell, if it is not the exterior label. Default: off.
 * - DroppedLabels: labels that are no cells and join the exterior, whether that is found or set. Default: none.
 * - DropSuspects: drop the labels that tissue::FindSuspectCells() names, too. Default: off. */
#define itkExteriorLabelMacro()                                                                                        \
  virtual void SetExteriorLabel(tissue::Label label)                                                                   \
  {                                                                                                                    \
    if (m_Exterior.isAutomatic || m_Exterior.labels != std::vector<tissue::Label>{ label })                            \
    {                                                                                                                  \
      m_Exterior.labels = { label };                                                                                   \
      m_Exterior.isAutomatic = false;                                                                                  \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  virtual tissue::Label GetExteriorLabel() const                                                                       \
  {                                                                                                                    \
    return m_Exterior.labels.empty() ? tissue::Label{ 0 } : m_Exterior.labels.front();                                 \
  }                                                                                                                    \
  virtual void AddExteriorLabel(tissue::Label label)                                                                   \
  {                                                                                                                    \
    if (m_Exterior.isAutomatic)                                                                                        \
    {                                                                                                                  \
      this->SetExteriorLabel(label);                                                                                   \
    }                                                                                                                  \
    else if (itk::ExteriorLabelSettings::Add(label, m_Exterior.labels))                                                \
    {                                                                                                                  \
      this->Modified();                                                                                                \
    }                                                                                                                  \
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
  itkBooleanMacro(ZeroIsCell);                                                                                         \
  virtual void AddDroppedLabel(tissue::Label label)                                                                    \
  {                                                                                                                    \
    if (itk::ExteriorLabelSettings::Add(label, m_Exterior.dropped))                                                    \
    {                                                                                                                  \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  virtual void ClearDroppedLabels()                                                                                    \
  {                                                                                                                    \
    if (!m_Exterior.dropped.empty())                                                                                   \
    {                                                                                                                  \
      m_Exterior.dropped.clear();                                                                                      \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  virtual void SetDropSuspects(bool dropsSuspects)                                                                     \
  {                                                                                                                    \
    if (m_Exterior.dropsSuspects != dropsSuspects)                                                                     \
    {                                                                                                                  \
      m_Exterior.dropsSuspects = dropsSuspects;                                                                        \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  virtual bool GetDropSuspects() const                                                                                 \
  {                                                                                                                    \
    return m_Exterior.dropsSuspects;                                                                                   \
  }                                                                                                                    \
  itkBooleanMacro(DropSuspects)

#endif
