/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkTissueVotes.h"

namespace itk
{
TissueVotes::LabelsContainer::Pointer
TissueVotes::GetLabels() const
{
  const auto container = LabelsContainer::New();
  for (const tissue::JunctionVote & vote : m_Votes)
  {
    for (const tissue::VertexId label : vote.cells)
    {
      container->push_back(static_cast<IdentifierType>(label));
    }
  }
  return container;
}

TissueVotes::RealContainer::Pointer
TissueVotes::GetShares() const
{
  const auto container = RealContainer::New();
  for (const tissue::JunctionVote & vote : m_Votes)
  {
    container->push_back(vote.share);
  }
  return container;
}

void
TissueVotes::Initialize()
{
  Superclass::Initialize();
  m_Votes.clear();
}

void
TissueVotes::Graft(const DataObject * data)
{
  const auto * const other = dynamic_cast<const Self *>(data);
  if (!other)
  {
    itkExceptionMacro("Only another TissueVotes can be grafted onto this one.");
  }
  m_Votes = other->m_Votes;
}

void
TissueVotes::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Votes: " << m_Votes.size() << std::endl;
}
} // namespace itk
