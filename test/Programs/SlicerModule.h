/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SlicerModule_h
#define SlicerModule_h

#include <gtest/gtest.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

/** A parameter of a command line module, as 3D Slicer reads it from the module's XML. */
struct SlicerParameter
{
  std::string                        tag;
  std::map<std::string, std::string> attributes;
  /** The texts of the elements within it, of which one name may be there several times. */
  std::multimap<std::string, std::string> texts;

  std::string
  Text(const std::string & name) const
  {
    const auto text = texts.find(name);
    return text == texts.end() ? std::string() : text->second;
  }

  bool
  Has(const std::string & name) const
  {
    return texts.count(name) > 0;
  }

  std::set<std::string>
  Elements() const
  {
    std::set<std::string> elements;
    for (auto [text, end] = texts.equal_range("element"); text != end; ++text)
    {
      elements.insert(text->second);
    }
    return elements;
  }
};

/** \brief A command line module, read from its XML by the rules of 3D Slicer's parser.
 *
 * What breaks a rule fails the test that reads it. */
class SlicerModuleXML
{
public:
  explicit SlicerModuleXML(const std::string & xml)
  {
    EXPECT_EQ(xml.rfind("<?xml ", 0), 0u) << xml;
    const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(xml.c_str()));
    if (root == nullptr || std::string(root->GetName()) != "executable")
    {
      ADD_FAILURE() << "no <executable>: " << xml;
      return;
    }
    for (int i = 0; i < root->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement * const element = root->GetNestedElement(i);
      if (std::string(element->GetName()) == "parameters")
      {
        this->ReadGroup(element);
      }
      else
      {
        about[element->GetName()] = TextOf(element);
      }
    }
    for (const char * name : { "category", "title", "description", "version" })
    {
      EXPECT_NE(about[name], "") << name;
    }
    this->CheckNames();
  }

  const SlicerParameter &
  Find(const std::string & name) const
  {
    static const SlicerParameter none;
    const auto                   found = std::find_if(
      parameters.begin(), parameters.end(), [&name](const SlicerParameter & p) { return p.Text("name") == name; });
    EXPECT_NE(found, parameters.end()) << name;
    return found == parameters.end() ? none : *found;
  }

  bool
  HasNone(const std::string & name) const
  {
    return std::none_of(
      parameters.begin(), parameters.end(), [&name](const SlicerParameter & p) { return p.Text("name") == name; });
  }

  /** \brief The arguments that Slicer starts the module with.
   *
   * \param values by name; of files and nodes the path. What is not among them has its default. */
  std::string
  ComposeCommandLine(const std::map<std::string, std::string> & values, const std::string & returnFile) const
  {
    std::string                line;
    std::map<int, std::string> indexed;
    const bool                 hasResults =
      std::any_of(parameters.begin(), parameters.end(), [](const SlicerParameter & p) { return IsResult(p); });
    line += hasResults ? " --returnparameterfile " + returnFile : "";
    for (const SlicerParameter & parameter : parameters)
    {
      const auto        value = values.find(parameter.Text("name"));
      const std::string text = value != values.end() ? value->second : parameter.Text("default");
      const std::string flag = " --" + parameter.Text("longflag");
      // Slicer passes the value of each simple type, though it be empty.
      const bool isAlwaysPassed = parameter.tag == "integer" || parameter.tag == "double" || parameter.tag == "float" ||
                                  parameter.tag == "string-enumeration";
      if (parameter.Has("index"))
      {
        indexed[std::stoi(parameter.Text("index"))] = text;
      }
      else if (parameter.Has("longflag") && parameter.tag == "boolean")
      {
        line += text == "true" ? flag : "";
      }
      else if (parameter.Has("longflag") && (isAlwaysPassed || !text.empty()))
      {
        line += flag + " '" + text + "'";
      }
    }
    for (const auto & [index, text] : indexed)
    {
      line += " '" + text + "'";
    }
    return line;
  }

  static bool
  IsResult(const SlicerParameter & parameter)
  {
    return parameter.Text("channel") == "output" && !parameter.Has("longflag") && !parameter.Has("index");
  }

  std::map<std::string, std::string> about;
  std::vector<SlicerParameter>       parameters;

private:
  static std::string
  TextOf(vtkXMLDataElement * element)
  {
    return element->GetCharacterData() != nullptr ? element->GetCharacterData() : "";
  }

  void
  ReadGroup(vtkXMLDataElement * group)
  {
    std::set<std::string> seen;
    for (int i = 0; i < group->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement * const element = group->GetNestedElement(i);
      seen.insert(element->GetName());
      if (element->GetNumberOfNestedElements() > 0)
      {
        this->ReadParameter(element);
      }
    }
    EXPECT_TRUE(seen.count("label") == 1 && seen.count("description") == 1);
    EXPECT_GT(seen.size(), 2u) << "an empty group";
  }

  void
  ReadParameter(vtkXMLDataElement * element)
  {
    SlicerParameter parameter;
    parameter.tag = element->GetName();
    for (int i = 0; i < element->GetNumberOfAttributes(); ++i)
    {
      parameter.attributes[element->GetAttributeName(i)] = element->GetAttributeValue(i);
    }
    for (int i = 0; i < element->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement * const text = element->GetNestedElement(i);
      parameter.texts.emplace(text->GetName(), TextOf(text));
      for (int j = 0; j < text->GetNumberOfNestedElements(); ++j)
      {
        parameter.texts.emplace(text->GetNestedElement(j)->GetName(), TextOf(text->GetNestedElement(j)));
      }
    }
    CheckParameter(parameter);
    parameters.push_back(parameter);
  }

  static void
  CheckParameter(const SlicerParameter & parameter)
  {
    static const std::map<std::string, std::set<std::string>> attributes{
      { "integer", { "hidden", "multiple" } },
      { "double", { "hidden", "multiple" } },
      { "string", { "hidden", "multiple" } },
      { "boolean", { "hidden" } },
      { "string-enumeration", { "hidden" } },
      { "integer-vector", {} },
      { "double-vector", {} },
      { "string-vector", {} },
      { "file", { "multiple", "fileExtensions" } },
      { "image", { "multiple", "type", "fileExtensions", "hidden", "reference" } },
      { "geometry", { "multiple", "aggregate", "type", "fileExtensions", "reference" } },
      { "table", { "multiple", "type", "fileExtensions", "hidden", "reference" } },
      { "pointfile", { "multiple", "type", "fileExtensions", "coordinateSystem" } }
    };
    static const std::set<std::string> elements{ "name",        "longflag", "index",   "label",
                                                 "description", "default",  "channel", "element",
                                                 "constraints", "minimum",  "maximum", "step" };
    const std::string                  name = parameter.Text("name");
    ASSERT_EQ(attributes.count(parameter.tag), 1u) << parameter.tag << " of " << name;
    for (const auto & [attribute, value] : parameter.attributes)
    {
      EXPECT_EQ(attributes.at(parameter.tag).count(attribute), 1u) << attribute << " of " << name;
    }
    for (const auto & [element, text] : parameter.texts)
    {
      EXPECT_EQ(elements.count(element), 1u) << element << " of " << name;
      EXPECT_TRUE(element == "element" || parameter.texts.count(element) == 1) << element << " of " << name;
    }
    for (const char * needed : { "name", "label", "description" })
    {
      EXPECT_NE(parameter.Text(needed), "") << needed << " of " << name;
    }
    EXPECT_TRUE(!parameter.Has("index") || !parameter.Has("longflag")) << name;
    const bool isOfChannel = parameter.tag == "file" || parameter.tag == "image" || parameter.tag == "geometry" ||
                             parameter.tag == "table" || parameter.tag == "pointfile" || IsResult(parameter);
    EXPECT_TRUE(!isOfChannel || parameter.Text("channel") == "input" || parameter.Text("channel") == "output") << name;
    CheckDefault(parameter);
  }

  static void
  CheckDefault(const SlicerParameter & parameter)
  {
    const std::string name = parameter.Text("name");
    const std::string value = parameter.Text("default");
    if (parameter.tag == "integer" || parameter.tag == "double")
    {
      // Slicer's fields know no exponents, and round to the digits after the point.
      const bool isInteger = parameter.tag == "integer";
      EXPECT_TRUE(std::regex_match(value, std::regex(isInteger ? "-?[0-9]+" : "-?[0-9]+(\\.[0-9]+)?")))
        << name << ": " << value;
      if (parameter.Has("constraints"))
      {
        EXPECT_LE(std::stod(parameter.Text("minimum")), std::stod(value)) << name;
        EXPECT_GE(std::stod(parameter.Text("maximum")), std::stod(value)) << name;
        const double steps = std::stod(parameter.Text("maximum")) / std::stod(parameter.Text("step"));
        EXPECT_LT(steps, 2147483647.0) << name;
      }
    }
    if (parameter.tag == "boolean")
    {
      EXPECT_EQ(value, "false") << name;
    }
    if (parameter.tag == "string-enumeration")
    {
      EXPECT_EQ(parameter.Elements().count(value), 1u) << name << ": " << value;
    }
  }

  void
  CheckNames() const
  {
    std::set<std::string> names;
    std::set<std::string> flags;
    std::set<std::string> indices;
    const std::regex      variable("[A-Za-z_][A-Za-z0-9_]*");
    for (const SlicerParameter & parameter : parameters)
    {
      const std::string name = parameter.Text("name");
      const std::string flag = parameter.Text("longflag");
      EXPECT_TRUE(names.insert(name).second) << name;
      EXPECT_TRUE(std::regex_match(name, variable)) << name;
      EXPECT_TRUE(!parameter.Has("longflag") || flags.insert(flag).second) << flag;
      EXPECT_TRUE(!parameter.Has("longflag") || std::regex_match(flag, variable)) << flag;
      EXPECT_TRUE(!parameter.Has("index") || indices.insert(parameter.Text("index")).second) << name;
    }
    for (const char * index : { "0", "1" })
    {
      EXPECT_EQ(indices.count(index), 1u) << index;
    }
  }
};

#endif
