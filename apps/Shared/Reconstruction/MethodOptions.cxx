/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/MethodOptions.h"

#include "TissueTessellationCore/Reconstruction/ParameterTable.h"

#include <nlohmann/json.hpp>

#include <stdexcept>

namespace tissue
{
namespace
{
/** Adds the option of a parameter, which overrides the preset, whatever their order on the command line. */
class ParameterOption
{
public:
  ParameterOption(CLI::App & app, const Parameter & parameter, ReconstructionParameters & parameters)
    : m_App(app)
    , m_Name("--" + parameter.option)
    , m_Words(parameter.words)
    , m_Default(ToString(GetValue(parameter, parameters)))
    , m_Parameters(parameters)
  {}

  template <typename TKind>
  CLI::Option *
  operator()(const TKind & kind) const
  {
    return m_App.add_option(m_Name, kind.member(m_Parameters), m_Words)
      ->capture_default_str()
      ->check(InRange(kind.range.least, kind.range.most));
  }

  /** The range and 0 beside it are left to RequireInRange(). */
  CLI::Option *
  operator()(const RealParameter & kind) const
  {
    CLI::Option * const option = m_App.add_option(m_Name, kind.member(m_Parameters), m_Words)->capture_default_str();
    return kind.range.orZero ? option : option->check(InRange(kind.range.least, kind.range.most));
  }

  CLI::Option *
  operator()(const BooleanParameter & kind) const
  {
    return m_App.add_option(m_Name, kind.member(m_Parameters), m_Words)->capture_default_str();
  }

  CLI::Option *
  operator()(const EnumerationParameter & kind) const
  {
    const auto set = [&kind, &parameters = m_Parameters](const std::string & name) { kind.Set(parameters, name); };
    return m_App.add_option_function<std::string>(m_Name, set, m_Words)
      ->check(CLI::IsMember(kind.GetNames()))
      ->default_str(m_Default);
  }

private:
  CLI::App &                 m_App;
  std::string                m_Name;
  std::string                m_Words;
  std::string                m_Default;
  ReconstructionParameters & m_Parameters;
};
/** Refuses every value of an option that the preset does not know, rather than to ignore it. */
CLI::Validator
OfOtherPreset(const Parameter & parameter)
{
  const std::string fault =
    *parameter.source == ComplexSource::Centers ? "only with --preset paper" : "not with --preset paper";
  return CLI::Validator([fault](const std::string &) { return fault; }, "");
}
} // namespace

MethodOptions
ChoosePreset(const FoundOptions & found, const ReconstructionParameters & byDefault,
             const ReconstructionParameters & ofPaper)
{
  MethodOptions options;
  const auto    preset = found.find(PresetOption);
  if (preset != found.end())
  {
    options.preset = preset->second;
  }
  options.parameters = options.preset == "paper" ? ofPaper : byDefault;
  return options;
}

void
AddMethodOptions(CLI::App & app, MethodOptions & options)
{
  const std::string group = "Method";
  app
    .add_option(
      PresetOption, options.preset, "default, or paper: the method of the paper, for points with --delaunayWeight")
    ->check(CLI::IsMember({ "default", "paper" }))
    ->capture_default_str()
    ->group(group);
  for (const Parameter & parameter : GetParameterTable())
  {
    if (parameter.use == ParameterUse::Option)
    {
      CLI::Option * const option = std::visit(ParameterOption(app, parameter, options.parameters), parameter.kind);
      if (IsUsed(parameter, options.parameters))
      {
        option->group(group);
      }
      else
      {
        option->group(OtherPresetGroup)->check(OfOtherPreset(parameter));
      }
    }
  }
}

void
RequireInRange(const ReconstructionParameters & parameters)
{
  for (const Parameter & parameter : GetParameterTable())
  {
    const std::string fault = FindFault(parameter, parameters);
    if (!fault.empty())
    {
      throw std::runtime_error("--" + parameter.option + ' ' + fault);
    }
  }
}

void
AddToJson(const ReconstructionParameters & parameters, nlohmann::ordered_json & json)
{
  nlohmann::ordered_json fixed;
  for (const Parameter & parameter : GetParameterTable())
  {
    if (parameter.use != ParameterUse::Internal && IsUsed(parameter, parameters))
    {
      auto & group = parameter.use == ParameterUse::Fixed ? fixed : json;
      std::visit([&](const auto & value) { group[parameter.option] = value; }, GetValue(parameter, parameters));
    }
  }
  json["fixed"] = fixed;
}
} // namespace tissue
