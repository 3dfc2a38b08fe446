/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/SlicerModuleDescription.h"

#include "Shared/CommandLine/OptionType.h"

#include <vtkNew.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

namespace tissue
{
namespace
{
const std::string ProgressOption = "progress";

/** A number as Slicer takes it: it counts the digits after the point, and knows no exponents. */
std::string
WithoutExponent(double value)
{
  char       text[400];
  const auto end = std::to_chars(text, text + sizeof(text), value, std::chars_format::fixed).ptr;
  return { text, end };
}

/** "closeGaps" as "Close gaps". */
std::string
ToLabel(const std::string & name)
{
  std::string label;
  for (const char c : name)
  {
    const bool isUpper = c >= 'A' && c <= 'Z';
    label += label.empty() ? std::string(1, static_cast<char>(std::toupper(c)))
             : isUpper     ? std::string(" ") + static_cast<char>(std::tolower(c))
                           : std::string(1, c);
  }
  return label;
}

/** Writes the parameters of a module. */
class ModuleDocument
{
public:
  ModuleDocument(const CLI::App & app, const SlicerModule & module)
    : m_App(app)
    , m_Module(module)
  {
    m_Root->SetName("executable");
    AddText(m_Root, "category", "Plant Tissue");
    AddText(m_Root, "title", module.title);
    AddText(m_Root, "description", app.get_description());
    AddText(m_Root, "version", TISSUE_TESSELLATION_VERSION);
    AddText(m_Root, "license", "Apache-2.0");
    AddText(m_Root, "contributor", "The TissueTessellation contributors");
    AddText(m_Root,
            "acknowledgements",
            "After G. Cerutti, S. Ribes, C. Galvan-Ampudia, T. Vernoux, C. Godin: 3-D tessellation of plant tissue: a "
            "dual optimization approach to cell-level meristem reconstruction from microscopy images. 3DV 2015, "
            "doi:10.1109/3DV.2015.57");
    this->AddFiles();
    for (const std::string & group : app.get_groups())
    {
      this->AddGroup(group);
    }
    this->AddResults();
  }

  std::string
  ToString() const
  {
    std::ostringstream text;
    text << "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n";
    vtkIndent indent;
    vtkXMLUtilities::FlattenElement(m_Root, text, &indent);
    std::string lines = text.str();
    lines.erase(lines.find_last_not_of('\n') + 1);
    return lines;
  }

private:
  static vtkXMLDataElement *
  AddElement(vtkXMLDataElement * parent, const std::string & name)
  {
    const vtkNew<vtkXMLDataElement> element;
    element->SetName(name.c_str());
    element->SetAttributeEncoding(VTK_ENCODING_UTF_8);
    parent->AddNestedElement(element);
    return element;
  }

  static void
  AddText(vtkXMLDataElement * parent, const std::string & name, const std::string & text)
  {
    AddElement(parent, name)->SetCharacterData(text.c_str(), static_cast<int>(text.size()));
  }

  vtkXMLDataElement *
  AddParameters(const std::string & label, const std::string & description, bool isAdvanced)
  {
    vtkXMLDataElement * const group = AddElement(m_Root, "parameters");
    if (isAdvanced)
    {
      group->SetAttribute("advanced", "true");
    }
    AddText(group, "label", label);
    AddText(group, "description", description);
    return group;
  }

  std::optional<SlicerUse>
  FindUse(const CLI::Option & option) const
  {
    for (const std::string & key : { option.get_name(), option.get_group() })
    {
      const auto use = m_Module.uses.find(key);
      if (use != m_Module.uses.end())
      {
        return use->second;
      }
    }
    return std::nullopt;
  }

  bool
  IsShown(const CLI::Option & option) const
  {
    const auto & names = option.get_lnames();
    const bool   isOfProgram = option.get_group().empty() || option.get_group() == SlicerGroup ||
                             &option == m_App.get_help_ptr() || &option == m_App.get_version_ptr() ||
                             (!names.empty() && (names.front() == ProgressOption || names.front() == "quiet"));
    return !isOfProgram && FindUse(option) != SlicerUse::LeftOut;
  }

  /** The positional arguments, and the progress that Slicer is to be told. */
  void
  AddFiles()
  {
    vtkXMLDataElement * const group = this->AddParameters("Input and output", "What is read and written", false);
    int                       index = 0;
    for (const CLI::Option * const option : m_App.get_options())
    {
      if (option->get_positional())
      {
        this->AddOption(*option, group);
        AddText(group->GetNestedElement(group->GetNumberOfNestedElements() - 1), "index", std::to_string(index++));
      }
    }
    vtkXMLDataElement * const progress = AddElement(group, "string");
    progress->SetAttribute("hidden", "true");
    AddText(progress, "name", ProgressOption);
    AddText(progress, "longflag", ProgressOption);
    AddText(progress, "label", "Progress");
    AddText(progress, "description", "How progress is shown");
    AddText(progress, "default", "slicer");
  }

  void
  AddGroup(const std::string & name)
  {
    vtkXMLDataElement * group = nullptr;
    for (const CLI::Option * const option : m_App.get_options())
    {
      if (option->get_group() == name && !option->get_positional() && this->IsShown(*option))
      {
        group = group != nullptr ? group : this->AddParameters(name, name, true);
        this->AddOption(*option, group);
        AddText(
          group->GetNestedElement(group->GetNumberOfNestedElements() - 1), "longflag", option->get_lnames().front());
      }
    }
  }

  void
  AddResults()
  {
    vtkXMLDataElement * const group =
      m_Module.results.empty() ? nullptr : this->AddParameters("Results", "What was found", false);
    for (const SlicerResult & result : m_Module.results)
    {
      vtkXMLDataElement * const element = AddElement(group, result.type);
      AddText(element, "name", result.name);
      AddText(element, "label", ToLabel(result.name));
      AddText(element, "description", result.description);
      AddText(element, "default", "0");
      AddText(element, "channel", "output");
    }
  }

  /** All of an option but how it is passed. */
  void
  AddOption(const CLI::Option & option, vtkXMLDataElement * group) const
  {
    const OptionType          type(option);
    vtkXMLDataElement * const element = AddElement(group, "string");
    const std::string         name = option.get_positional() ? option.get_name(true) : option.get_lnames().front();
    AddText(element, "name", name);
    AddText(element, "label", ToLabel(name));
    AddText(element, "description", option.get_description());
    const std::optional<SlicerUse> use = this->FindUse(option);
    if (use)
    {
      SetUse(*use, element);
    }
    else if (!type.extension.empty() || type.type == "FILE")
    {
      SetFile(type.extension, element);
    }
    else
    {
      SetValue(option, type, element);
    }
  }

  static void
  SetUse(SlicerUse use, vtkXMLDataElement * element)
  {
    const bool isImage = use == SlicerUse::LabelImage || use == SlicerUse::Image;
    element->SetName(isImage ? "image" : "pointfile");
    element->SetAttribute("type", use == SlicerUse::LabelImage ? "label" : use == SlicerUse::Image ? "any" : "point");
    if (!isImage)
    {
      element->SetAttribute("fileExtensions", ".mrk.json,.fcsv");
      element->SetAttribute("coordinateSystem", "lps");
    }
    AddText(element, "channel", use == SlicerUse::OutputPoints ? "output" : "input");
  }

  static void
  SetFile(const std::string & extension, vtkXMLDataElement * element)
  {
    const bool isGeometry = extension == ".vtp" || extension == ".vtu";
    element->SetName(isGeometry ? "geometry" : extension == ".csv" ? "table" : "file");
    if (isGeometry)
    {
      element->SetAttribute("type", "model");
    }
    if (!extension.empty())
    {
      element->SetAttribute("fileExtensions", extension.c_str());
    }
    AddText(element, "channel", extension.empty() ? "input" : "output");
  }

  static void
  SetValue(const CLI::Option & option, const OptionType & type, vtkXMLDataElement * element)
  {
    const bool isFlag = option.get_expected_max() == 0 && !type.least;
    const auto number = FindNumber(option.get_default_str());
    if (isFlag)
    {
      element->SetName("boolean");
      AddText(element, "default", "false");
    }
    else if (option.get_items_expected_max() > 1)
    {
      element->SetName(type.isReal ? "double-vector" : type.isInteger ? "integer-vector" : "string-vector");
    }
    else if (!type.choices.empty())
    {
      element->SetName("string-enumeration");
      AddText(element, "default", option.get_default_str());
      for (const std::string & choice : type.choices)
      {
        AddText(element, "element", choice);
      }
    }
    else if ((type.isReal || type.isInteger) && number && type.Contains(*number))
    {
      element->SetName(type.isReal ? "double" : "integer");
      AddText(element, "default", WithoutExponent(*number));
      AddConstraints(type, element);
    }
    else if (!type.isReal && !type.isInteger && !option.get_default_str().empty())
    {
      AddText(element, "default", option.get_default_str());
    }
  }

  static void
  AddConstraints(const OptionType & type, vtkXMLDataElement * element)
  {
    constexpr double most = 1e4;
    if (!type.least || !type.most || *type.least < -most || *type.most > most)
    {
      return;
    }
    // A hundredth of the range, in a round number.
    const double              step = std::pow(10.0, std::floor(std::log10((*type.most - *type.least) / 100.0) + 1e-9));
    vtkXMLDataElement * const constraints = AddElement(element, "constraints");
    AddText(constraints, "minimum", WithoutExponent(*type.least));
    AddText(constraints, "maximum", WithoutExponent(*type.most));
    AddText(constraints, "step", type.isReal ? WithoutExponent(step) : "1");
  }

  const CLI::App &                m_App;
  const SlicerModule &            m_Module;
  const vtkNew<vtkXMLDataElement> m_Root;
};
} // namespace

std::string
DescribeSlicerModule(const CLI::App & app, const SlicerModule & module)
{
  return ModuleDocument(app, module).ToString();
}
} // namespace tissue
