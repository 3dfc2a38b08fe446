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
#include <vtkTextActor.h>
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
  // As parts of the picture.
  constexpr double                fontHeight = 0.026;
  constexpr double                left = 0.52;
  constexpr double                width = 0.42;
  constexpr double                bottom = 0.055;
  constexpr double                height = 0.07;
  const vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(scale.GetTable());
  bar->SetOrientationToHorizontal();
  bar->UnconstrainedFontSizeOn();
  SetText(bar->GetLabelTextProperty(), fontHeight * size[1]);
  SetText(bar->GetAnnotationTextProperty(), fontHeight * size[1]);
  bar->SetMaximumNumberOfColors(256);
  bar->SetNumberOfLabels(scale.IsOfCategories() ? 0 : 5);
  bar->SetLabelFormat("%.3g");
  bar->SetDrawNanAnnotation(scale.HasUnknown());
  bar->SetNanAnnotation("unknown");
  // What is grey, and the names of categories, are below the bar, the numbers above.
  bar->SetBarRatio(0.6);
  bar->SetPosition(left, bottom);
  bar->SetPosition2(width, height);
  renderer->AddActor2D(bar);

  // The bar would put its title onto the numbers.
  const vtkNew<vtkTextActor> text;
  text->SetInput(title.c_str());
  SetText(text->GetTextProperty(), fontHeight * size[1]);
  text->GetTextProperty()->SetJustificationToCentered();
  text->SetPosition((left + 0.5 * width) * size[0], (bottom + height + 0.01) * size[1]);
  renderer->AddActor2D(text);
}
} // namespace tissue
