/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/GraphFile.h"

#include "Shared/Files/TableColumns.h"
#include "Shared/Files/VTKFiles.h"

#include <vtkTable.h>

namespace tissue
{
namespace
{
/** The columns of nodes or edges that are attributes, by the ids of their keys: a letter and a number. */
struct Attributes
{
  char                     letter;
  std::vector<TableColumn> columns;

  std::string
  KeyOf(std::size_t column) const
  {
    return letter + std::to_string(column);
  }
};

std::string
Escape(const std::string & text)
{
  std::string escaped;
  for (const char c : text)
  {
    // XML has no control characters but these three.
    const bool isControl = static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
    switch (c)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += isControl ? ' ' : c;
    }
  }
  return escaped;
}

void
AppendKeys(const Attributes & attributes, const char * owner, std::string & text)
{
  for (std::size_t c = 0; c < attributes.columns.size(); ++c)
  {
    const TableColumn & column = attributes.columns[c];
    const ValueType     type = TypeOf(column);
    text += "  <key id=\"" + attributes.KeyOf(c) + "\" for=\"" + owner + "\" attr.name=\"" + Escape(column.name) +
            "\" attr.type=\"" +
            (type == ValueType::Text     ? "string"
             : type == ValueType::Number ? "double"
                                         : "long") +
            "\"/>\n";
  }
}

void
AppendData(const Attributes & attributes, vtkIdType row, std::string & text)
{
  for (std::size_t c = 0; c < attributes.columns.size(); ++c)
  {
    const std::string value = ToText(attributes.columns[c], row);
    if (!value.empty())
    {
      text += "<data key=\"" + attributes.KeyOf(c) + "\">" + Escape(value) + "</data>";
    }
  }
}
} // namespace

void
WriteGraphML(vtkTable * nodes, vtkTable * edges, const std::string & path)
{
  const Attributes         ofNodes{ 'n', ListColumns(nodes) };
  std::vector<TableColumn> ends = ListColumns(edges);
  const Attributes         ofEdges{ 'e', { ends.begin() + 2, ends.end() } };
  std::string              text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                                  "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
  AppendKeys(ofNodes, "node", text);
  AppendKeys(ofEdges, "edge", text);
  text += "  <graph edgedefault=\"undirected\">\n";
  for (vtkIdType row = 0; row < nodes->GetNumberOfRows(); ++row)
  {
    text += "    <node id=\"" + ToText(ofNodes.columns.front(), row) + "\">";
    AppendData(ofNodes, row, text);
    text += "</node>\n";
  }
  for (vtkIdType row = 0; row < edges->GetNumberOfRows(); ++row)
  {
    text += "    <edge source=\"" + ToText(ends[0], row) + "\" target=\"" + ToText(ends[1], row) + "\">";
    AppendData(ofEdges, row, text);
    text += "</edge>\n";
  }
  WriteBytes(text + "  </graph>\n</graphml>\n", path);
}
} // namespace tissue
