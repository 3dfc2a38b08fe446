/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkTissueVotes.h"

#include "itkTissueJunctions.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{
itk::TissueVotes::Pointer
MakeVotes()
{
  const auto votes = itk::TissueVotes::New();
  votes->SetVotes({ { { { 0, 1, 2, 4 } }, 0.25 }, { { { 1, 2, 3, 4 } }, 1.0 } });
  return votes;
}
} // namespace

TEST(TissueVotes, GivesLabelsAndSharesAsFlatArrays)
{
  const auto votes = MakeVotes();
  EXPECT_EQ(votes->GetNumberOfVotes(), 2u);
  EXPECT_EQ(votes->GetLabels()->CastToSTLConstContainer(),
            (std::vector<itk::IdentifierType>{ 0, 1, 2, 4, 1, 2, 3, 4 }));
  EXPECT_EQ(votes->GetShares()->CastToSTLConstContainer(), (std::vector<double>{ 0.25, 1.0 }));
}

TEST(TissueVotes, IsEmptyAtFirstAndAfterInitialize)
{
  EXPECT_EQ(itk::TissueVotes::New()->GetNumberOfVotes(), 0u);
  const auto votes = MakeVotes();
  votes->Initialize();
  EXPECT_EQ(votes->GetNumberOfVotes(), 0u);
}

TEST(TissueVotes, NewVotesModifyItAndAGraftCopiesThem)
{
  const auto votes = MakeVotes();
  const auto other = itk::TissueVotes::New();
  other->Graft(votes);
  const auto before = votes->GetMTime();
  votes->SetVotes({});
  EXPECT_GT(votes->GetMTime(), before);
  EXPECT_EQ(other->GetNumberOfVotes(), 2u);
  EXPECT_THROW(other->Graft(itk::TissueJunctions::New()), itk::ExceptionObject);
  std::ostringstream text;
  other->Print(text);
  EXPECT_NE(text.str().find("Votes: 2"), std::string::npos);
}
