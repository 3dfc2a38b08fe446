/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef WriteOrThrow_h
#define WriteOrThrow_h

#include <vtkCallbackCommand.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

#include <stdexcept>
#include <string>

namespace tissue
{
/** Runs a writer of VTK; its errors, which VTK would print and forget, are thrown as std::runtime_error. */
template <typename TWriter>
void
WriteOrThrow(TWriter * writer, const std::string & path)
{
  std::string                errors;
  vtkNew<vtkCallbackCommand> collector;
  collector->SetClientData(&errors);
  collector->SetCallback([](vtkObject *, unsigned long, void * collected, void * message) {
    *static_cast<std::string *>(collected) += static_cast<const char *>(message);
  });
  writer->AddObserver(vtkCommand::ErrorEvent, collector);
  writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, collector);
  writer->SetFileName(path.c_str());
  writer->Write();
  const unsigned long code = writer->GetErrorCode();
  if (code != vtkErrorCode::NoError)
  {
    throw std::runtime_error(vtkErrorCode::GetStringFromErrorCode(code));
  }
  if (!errors.empty())
  {
    throw std::runtime_error(errors);
  }
}
} // namespace tissue

#endif
