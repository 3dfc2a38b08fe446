/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Image/LabelFragments.h"

#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace tissue
{
namespace
{
using RunId = std::size_t;

RunId
BeginOfRow(const LabelRuns & labels, std::size_t row)
{
  return row == 0 ? 0 : labels.endOfRow[row - 1];
}

/** Calls visit(run, run, faces) for each two runs of two rows that have voxel faces in common. */
template <typename TVisitor>
void
VisitContactsOfRows(const LabelRuns & labels, std::size_t row, std::size_t otherRow, const TVisitor & visit)
{
  RunId a = BeginOfRow(labels, row);
  RunId b = BeginOfRow(labels, otherRow);
  while (a < labels.endOfRow[row] && b < labels.endOfRow[otherRow])
  {
    const LabelRun & runA = labels.runs[a];
    const LabelRun & runB = labels.runs[b];
    visit(a, b, static_cast<std::int64_t>(std::min(runA.end, runB.end) - std::max(runA.begin, runB.begin)));
    const bool stepA = runA.end <= runB.end;
    const bool stepB = runB.end <= runA.end;
    a += stepA ? 1 : 0;
    b += stepB ? 1 : 0;
  }
}

/** Calls visit(run, run, faces) for each two runs of the image that have voxel faces in common, once a pair. */
template <typename TVisitor>
void
VisitContacts(const LabelRuns & labels, const TVisitor & visit)
{
  for (std::size_t row = 0; row < labels.endOfRow.size(); ++row)
  {
    for (RunId run = BeginOfRow(labels, row) + 1; run < labels.endOfRow[row]; ++run)
    {
      visit(run - 1, run, std::int64_t{ 1 });
    }
    if (row % labels.rowsPerLayer != 0)
    {
      VisitContactsOfRows(labels, row - 1, row, visit);
    }
    if (row >= labels.rowsPerLayer)
    {
      VisitContactsOfRows(labels, row - labels.rowsPerLayer, row, visit);
    }
  }
}

/** Finds the face-connected pieces of a label image. Each is a set of runs and known by its first run, which is given
 * for every run. */
std::vector<RunId>
FindPieces(const LabelRuns & labels)
{
  DisjointSets sets(labels.runs.size());
  VisitContacts(labels, [&](RunId a, RunId b, std::int64_t) {
    if (labels.runs[a].label == labels.runs[b].label)
    {
      sets.Unite(static_cast<std::int64_t>(a), static_cast<std::int64_t>(b));
    }
  });
  std::vector<RunId> pieces(labels.runs.size());
  for (RunId run = 0; run < pieces.size(); ++run)
  {
    pieces[run] = static_cast<RunId>(sets.Find(static_cast<std::int64_t>(run)));
  }
  return pieces;
}

/** Tells, by the first run of each piece, whether it keeps its label.
 *
 * One pass over the runs sums up the pieces' sizes and finds those of the exterior that touch the border of the image;
 * a second one finds each cell's largest piece. */
std::vector<bool>
FindKeptPieces(const LabelRuns & labels, const std::vector<RunId> & pieces, Label exterior)
{
  std::vector<std::int64_t> sizes(labels.runs.size(), 0);
  std::vector<bool>         isKept(labels.runs.size(), false);
  const std::size_t         numberOfRows = labels.endOfRow.size();
  for (std::size_t row = 0; row < numberOfRows; ++row)
  {
    const bool isBorderRow = row < labels.rowsPerLayer || row + labels.rowsPerLayer >= numberOfRows ||
                             row % labels.rowsPerLayer == 0 || (row + 1) % labels.rowsPerLayer == 0;
    const RunId begin = BeginOfRow(labels, row);
    for (RunId run = begin; run < labels.endOfRow[row]; ++run)
    {
      sizes[pieces[run]] += labels.runs[run].end - labels.runs[run].begin;
      if (labels.runs[run].label == exterior && (isBorderRow || run == begin || run + 1 == labels.endOfRow[row]))
      {
        isKept[pieces[run]] = true;
      }
    }
  }
  std::unordered_map<Label, RunId> largest;
  for (RunId run = 0; run < labels.runs.size(); ++run)
  {
    if (pieces[run] == run && labels.runs[run].label != exterior)
    {
      RunId & best = largest.emplace(labels.runs[run].label, run).first->second;
      best = sizes[run] > sizes[best] ? run : best;
    }
  }
  for (const auto & labelAndPiece : largest)
  {
    isKept[labelAndPiece.second] = true;
  }
  return isKept;
}

/** The numbers of faces that a fragment has in common with each of the pieces about it. */
using Contacts = std::map<RunId, std::int64_t>;

/** Chooses the label of the most faces among the contacts whose label is settled. Returns false if none is. */
bool
ChooseLabel(const Contacts & contacts, const std::map<RunId, Label> & settled, Label & chosen)
{
  std::map<Label, std::int64_t> facesOfLabel;
  for (const auto & pieceAndFaces : contacts)
  {
    const auto found = settled.find(pieceAndFaces.first);
    if (found != settled.end())
    {
      facesOfLabel[found->second] += pieceAndFaces.second;
    }
  }
  const auto most = std::max_element(
    facesOfLabel.begin(), facesOfLabel.end(), [](const auto & a, const auto & b) { return a.second < b.second; });
  if (most == facesOfLabel.end())
  {
    return false;
  }
  chosen = most->first;
  return true;
}

/** Finds the new label of every fragment, in rounds: fragments within fragments wait for those about them. */
std::map<RunId, Label>
ResolveFragments(std::map<RunId, Contacts> fragments, std::map<RunId, Label> settled)
{
  std::map<RunId, Label> newLabels;
  std::map<RunId, Label> round;
  do
  {
    round.clear();
    for (const auto & fragment : fragments)
    {
      Label label = 0;
      if (ChooseLabel(fragment.second, settled, label))
      {
        round[fragment.first] = label;
      }
    }
    for (const auto & pieceAndLabel : round)
    {
      fragments.erase(pieceAndLabel.first);
    }
    settled.insert(round.begin(), round.end());
    newLabels.insert(round.begin(), round.end());
  } while (!round.empty());
  return newLabels;
}
} // namespace

std::int64_t
MergeFragments(LabelRuns & labels, Label exterior)
{
  // Pieces that do not keep their label are fragments. Their faces with all other pieces are counted; labels
  // then spread from the kept pieces inwards, and the runs of the fragments take them.
  const std::vector<RunId>  pieces = FindPieces(labels);
  const std::vector<bool>   isKept = FindKeptPieces(labels, pieces, exterior);
  std::map<RunId, Contacts> fragments;
  std::map<RunId, Label>    settled;
  const auto                addContact = [&](RunId fragment, RunId other, std::int64_t faces) {
    if (!isKept[fragment] && fragment != other)
    {
      fragments[fragment][other] += faces;
      if (isKept[other])
      {
        settled[other] = labels.runs[other].label;
      }
    }
  };
  VisitContacts(labels, [&](RunId a, RunId b, std::int64_t faces) {
    addContact(pieces[a], pieces[b], faces);
    addContact(pieces[b], pieces[a], faces);
  });

  const std::map<RunId, Label> newLabels = ResolveFragments(std::move(fragments), std::move(settled));
  std::int64_t                 numberOfChanges = 0;
  for (RunId run = 0; run < labels.runs.size(); ++run)
  {
    if (!isKept[pieces[run]])
    {
      labels.runs[run].label = newLabels.at(pieces[run]);
      numberOfChanges += labels.runs[run].end - labels.runs[run].begin;
    }
  }
  return numberOfChanges;
}
} // namespace tissue
