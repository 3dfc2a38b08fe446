/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Reconstruction/ParameterTable.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
using P = ReconstructionParameters;
using Energy = EnergyParameters;
using Annealing = AnnealingParameters;

// Limits that no sensible value comes near. They keep the arithmetic finite.
constexpr double         LargestLength = 1e12;
constexpr ParameterRange Weight{ 0.0, 1e6 };
constexpr ParameterRange Temperature{ 1e-9, 1e6 };
constexpr ParameterRange Degree{ 3.0, 1e6 };
constexpr ParameterRange Repetitions{ 0.0, 1000.0 };
constexpr ParameterRange Neighbors{ 1.0, 100.0 };

/** The member at the end of a path of members. */
template <auto... Members>
auto &
At(P & parameters)
{
  return (parameters.*....*Members);
}

template <auto... Members>
EnumerationParameter
MakeEnumeration(const std::vector<std::pair<std::string, int>> & values)
{
  const auto get = [](P parameters) { return static_cast<int>(At<Members...>(parameters)); };
  const auto set = [](P & parameters, int value) {
    auto & member = At<Members...>(parameters);
    member = static_cast<std::decay_t<decltype(member)>>(value);
  };
  return { values, get, set };
}

void
Add(const std::string & name, const std::string & words, const decltype(Parameter::kind) & kind,
    std::vector<Parameter> & table)
{
  table.push_back({ name, name, ParameterUse::Option, std::nullopt, words, kind });
}

void
AddComplex(std::vector<Parameter> & table)
{
  Add("prefer",
      "What is right before all else: which cells touch, or which four meet",
      MakeEnumeration<&P::preference>({ { "junctions", static_cast<int>(AdjacencyPreference::Junctions) },
                                        { "walls", static_cast<int>(AdjacencyPreference::Walls) } }),
      table);
}

void
AddCleanUp(std::vector<Parameter> & table)
{
  Add("maximumEdgeLength",
      "l_max of the clean-up, in the image's units; 0: automatic",
      RealParameter{ At<&P::maximumEdgeLength>, { 0.0, LargestLength } },
      table);
  Add("maximumEdgeLengthFactor",
      "Automatic l_max over the median distance of neighbours, or over the local spacing",
      RealParameter{ At<&P::maximumEdgeLengthFactor>, { 0.1, 1e6 } },
      table);
  Add("localMaximumEdgeLength",
      "Whether the automatic l_max follows the local spacing of the centres (true or false)",
      BooleanParameter{ At<&P::localMaximumEdgeLength> },
      table);
}

void
AddAnnealing(std::vector<Parameter> & table)
{
  Add("legality",
      "What makes a change of the complex legal",
      MakeEnumeration<&P::annealing, &Annealing::legality>(
        { { "combinatorial", static_cast<int>(Legality::Combinatorial) },
          { "geometric", static_cast<int>(Legality::Geometric) } }),
      table);
  Add("ringRule",
      "Triangulation of the rings of removed edges",
      MakeEnumeration<&P::annealing, &Annealing::ringRule>(
        { { "delaunay", static_cast<int>(RingRule::ProjectedDelaunay) },
          { "reference", static_cast<int>(RingRule::BestOfReference) } }),
      table);
  table.back().option = "rings";
  Add("maximumDegree",
      "Largest degree of an edge that is removed",
      IntegerParameter{ At<&P::annealing, &Annealing::maximumDegree>, Degree },
      table);
  Add("numberOfCycles",
      "Temperature cycles",
      IntegerParameter{ At<&P::annealing, &Annealing::numberOfCycles>, Repetitions },
      table);
  Add("initialTemperature",
      "Of the first cycle, in energies of one quadruple or cell",
      RealParameter{ At<&P::annealing, &Annealing::initialTemperature>, Temperature },
      table);
  Add("coolingFactor",
      "Of the temperature, from cycle to cycle",
      RealParameter{ At<&P::annealing, &Annealing::coolingFactor>, { 1e-9, 1.0 } },
      table);
}

void
AddEnergy(std::vector<Parameter> & table)
{
  Add("adjacencyWeight",
      "Weight of the image term",
      RealParameter{ At<&P::energy, &Energy::adjacencyWeight>, Weight },
      table);
  Add("neighborWeight",
      "Weight of the prior on the numbers of neighbours",
      RealParameter{ At<&P::energy, &Energy::neighborWeight>, Weight },
      table);
  Add("lengthWeight",
      "Weight of the longest edges",
      RealParameter{ At<&P::energy, &Energy::lengthWeight>, Weight },
      table);
  Add("unitLength",
      "What their lengths are divided by; 0: the median local spacing of the centres",
      RealParameter{ At<&P::energy, &Energy::unitLength>, { 1e-12, LargestLength, true } },
      table);
  Add("delaunayWeight",
      "Weight of the deviation from the Delaunay tetrahedralization, which the paper has not",
      RealParameter{ At<&P::energy, &Energy::delaunayWeight>, Weight },
      table);
}

void
AddAnnealingSeed(std::vector<Parameter> & table)
{
  Add("seed",
      "Seed of the annealing",
      SeedParameter{ At<&P::annealing, &Annealing::seed>, { 0.0, 9007199254740992.0 } },
      table);
}

void
AddCorners(std::vector<Parameter> & table)
{
  Add("corners",
      "Where the cells' corners come from",
      MakeEnumeration<&P::corners>({ { "circumcenter", static_cast<int>(CornerRule::ProjectedCircumcenter) },
                                     { "image", static_cast<int>(CornerRule::ImageJunction) },
                                     { "lifted", static_cast<int>(CornerRule::LiftedCircumcenter) } }),
      table);
}

void
AddFittedWalls(std::vector<Parameter> & table)
{
  Add("trianglesPerCell",
      "Wanted triangles a cell, each counted once, 40 .. 10000",
      RealParameter{ At<&P::trianglesPerCell>, { 40.0, 10000.0 } },
      table);
  table.back().option = "triangles";
}

void
AddWalls(std::vector<Parameter> & table)
{
  Add("refinement",
      "0: the walls are stars; without a fit the times that each triangle is split in four, 0 .. 3",
      IntegerParameter{ At<&P::refinement>, { 0.0, 3.0 } },
      table);
}

void
AddSmoothing(std::vector<Parameter> & table)
{
  Add("smoothingIterations",
      "Iterations of the walls' smoothing",
      IntegerParameter{ At<&P::smoothingIterations>, { 0.0, 10000.0 } },
      table);
}

/** What no option sets. */
void
AddFixed(std::vector<Parameter> & table)
{
  Add("complex",
      "Where the adjacency complex comes from",
      MakeEnumeration<&P::source>({ { "centers", static_cast<int>(ComplexSource::Centers) },
                                    { "image", static_cast<int>(ComplexSource::Image) } }),
      table);
  Add("epidermalNeighbors",
      "Ideal number of neighbouring cells of an epidermal cell",
      RealParameter{ At<&P::energy, &Energy::epidermalNeighbors>, Neighbors },
      table);
  Add("innerNeighbors",
      "Ideal number of neighbouring cells of an inner cell",
      RealParameter{ At<&P::energy, &Energy::innerNeighbors>, Neighbors },
      table);
}

/** What follows from other choices of a program. */
void
AddSwitches(std::vector<Parameter> & table)
{
  Add("fitToImage",
      "Whether the walls are fitted to the label image, where there is one",
      BooleanParameter{ At<&P::fitToImage> },
      table);
  Add("keepStages", "Whether every stage keeps its tetrahedra", BooleanParameter{ At<&P::keepStages> }, table);
}

std::vector<Parameter>
MakeTable()
{
  std::vector<Parameter> table;
  const auto             addGroup = [&table](ParameterUse use, std::optional<ComplexSource> source, auto... groups) {
    const std::size_t first = table.size();
    (groups(table), ...);
    std::for_each(table.begin() + first, table.end(), [&](Parameter & parameter) {
      parameter.use = use;
      parameter.source = source;
    });
  };
  // Walls that are fitted to the image go with the complex that is taken from it, in the presets.
  addGroup(ParameterUse::Option, ComplexSource::Image, AddComplex, AddFittedWalls);
  addGroup(ParameterUse::Option, std::nullopt, AddWalls);
  addGroup(ParameterUse::Option,
           ComplexSource::Centers,
           AddCleanUp,
           AddAnnealing,
           AddAnnealingSeed,
           AddEnergy,
           AddCorners,
           AddSmoothing);
  addGroup(ParameterUse::Fixed, std::nullopt, AddFixed);
  addGroup(ParameterUse::Internal, std::nullopt, AddSwitches);
  return table;
}

template <typename TNumber>
std::string
FindFaultOfNumber(const TNumber & number, ReconstructionParameters parameters)
{
  const auto value = static_cast<double>(number.member(parameters));
  if (number.range.Contains(value))
  {
    return {};
  }
  std::ostringstream fault;
  fault << "is " << value << ", must be in " << number.range.least << " .. " << number.range.most;
  return fault.str();
}

/** Reads the value of a parameter of any kind. */
struct ValueReader
{
  /** A copy, as members can only be had of parameters that may be changed. */
  ReconstructionParameters parameters;

  template <typename TKind>
  ParameterValue
  operator()(const TKind & kind)
  {
    return kind.member(parameters);
  }

  ParameterValue
  operator()(const EnumerationParameter & kind)
  {
    const int value = kind.getValue(parameters);
    for (const auto & [name, named] : kind.values)
    {
      if (named == value)
      {
        return name;
      }
    }
    return std::string("unknown");
  }
};
} // namespace

std::vector<std::string>
EnumerationParameter::GetNames() const
{
  std::vector<std::string> names;
  for (const auto & [name, value] : values)
  {
    names.push_back(name);
  }
  return names;
}

void
EnumerationParameter::Set(ReconstructionParameters & parameters, const std::string & name) const
{
  const auto found =
    std::find_if(values.begin(), values.end(), [&name](const auto & named) { return named.first == name; });
  if (found == values.end())
  {
    throw std::invalid_argument("'" + name + "' is none of the names of the parameter's values");
  }
  setValue(parameters, found->second);
}

const std::vector<Parameter> &
GetParameterTable()
{
  static const std::vector<Parameter> table = MakeTable();
  return table;
}

bool
IsUsed(const Parameter & parameter, const ReconstructionParameters & parameters)
{
  return parameter.source.value_or(parameters.source) == parameters.source;
}

ParameterValue
GetValue(const Parameter & parameter, const ReconstructionParameters & parameters)
{
  return std::visit(ValueReader{ parameters }, parameter.kind);
}

std::string
ToString(const ParameterValue & value)
{
  std::ostringstream text;
  text << std::boolalpha;
  std::visit([&text](const auto & any) { text << any; }, value);
  return text.str();
}

std::string
FindFault(const Parameter & parameter, const ReconstructionParameters & parameters)
{
  if (const auto * const real = std::get_if<RealParameter>(&parameter.kind))
  {
    return FindFaultOfNumber(*real, parameters);
  }
  if (const auto * const integer = std::get_if<IntegerParameter>(&parameter.kind))
  {
    return FindFaultOfNumber(*integer, parameters);
  }
  return {};
}
} // namespace tissue
