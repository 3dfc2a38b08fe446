/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Pictures/PictureLegend.h"

#include <vtkNew.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextProperty.h>

namespace tissue
{
namespace
{
void
SetText(vtkTextProperty * text, double height)
{
  text->SetFontSize(static_cast<int>(height));
  text->SetColor(0.14, 0.14, 0.18);
  text->ItalicOff();
  text->BoldOff();
  text->ShadowOff();
}
} // namespace

void
AddLegend(vtkRenderer * renderer, const ColorScale & scale, const std::string & title, const std::array<int, 2> & size)
{
  constexpr double                fontHeight = 0.026;
  const vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(scale.GetTable());
  bar->SetOrientationToHorizontal();
  bar->UnconstrainedFontSizeOn();
  SetText(bar->GetTitleTextProperty(), fontHeight * size[1]);
  SetText(bar->GetLabelTextProperty(), fontHeight * size[1]);
  SetText(bar->GetAnnotationTextProperty(), fontHeight * size[1]);
  bar->SetTitle(title.c_str());
  bar->SetNumberOfLabels(scale.IsOfCategories() ? 0 : 5);
  bar->SetLabelFormat("%.3g");
  bar->SetDrawNanAnnotation(scale.HasUnknown());
  bar->SetNanAnnotation("unknown");
  bar->SetPosition(0.5, 0.02);
  bar->SetPosition2(0.46, LegendHeight - 0.04);
  renderer->AddActor2D(bar);
}
} // namespace tissue
