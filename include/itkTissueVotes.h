/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkTissueVotes_h
#define itkTissueVotes_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationExport.h"
#include "itkDataObject.h"
#include "itkObjectFactory.h"
#include "itkVectorContainer.h"

#include <vector>

namespace itk
{
/** \class TissueVotes
 * \brief How sure it is which cells of an estimated tissue meet, as an object of the pipeline.
 *
 * PointSetToTissueLabelImageFilter makes it with the label image of a tissue that is known by its cells' centres alone.
 * The filters that take that image take the votes, too, and then decide by them which four cells meet:
 *
 *     walls->SetInput(tissue->GetOutput());
 *     walls->SetVotes(tissue->GetVotes());
 *
 * Each vote is on four cells by their labels in the image, ascending, of which 0 is the exterior. Four cells without a
 * vote do not meet as far as the votes know.
 *
 * \sa PointSetToTissueLabelImageFilter LabelImageToCellWallMeshFilter LabelJunctionExtractionFilter
 * \ingroup TissueTessellation
 */
class TissueTessellation_EXPORT TissueVotes : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(TissueVotes);

  using Self = TissueVotes;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(TissueVotes, DataObject);

  using LabelsContainer = VectorContainer<IdentifierType, IdentifierType>;
  using RealContainer = VectorContainer<IdentifierType, double>;

  /** 0 for a layer of cells, whose image is taken at its word. */
  SizeValueType
  GetNumberOfVotes() const
  {
    return m_Votes.size();
  }

  /** The four labels of every vote, one after the other. */
  LabelsContainer::Pointer
  GetLabels() const;

  /** The share of the votes that are for it, above 0 and at most 1. */
  RealContainer::Pointer
  GetShares() const;

#ifndef ITK_WRAPPING_PARSER
  /** The votes, for C++; their cells are labels. */
  const std::vector<tissue::JunctionVote> &
  GetVotes() const
  {
    return m_Votes;
  }

  void
  SetVotes(std::vector<tissue::JunctionVote> votes)
  {
    m_Votes = std::move(votes);
    this->Modified();
  }
#endif

  /** Lets the votes go. */
  void
  Initialize() override;

  /** Copies the other object's votes. */
  void
  Graft(const DataObject * data) override;

protected:
  TissueVotes() = default;
  ~TissueVotes() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::vector<tissue::JunctionVote> m_Votes;
};
} // namespace itk

#endif
