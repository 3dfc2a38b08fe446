/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/SlicerOptions.h"

#include <iostream>

namespace tissue
{
void
AddSlicerOptions(CLI::App & app, const SlicerModule & module, std::string & returnParameterFile)
{
  const auto answer = [&app](const std::string & name, const std::string & words, auto makeText) {
    app
      .add_flag_callback(
        name, [makeText] { throw CLI::CallForVersion(makeText(), 0); }, words)
      ->group(SlicerGroup);
  };
  answer("--xml", "Print the description of the module", [&app, module] { return DescribeSlicerModule(app, module); });
  answer("--logo", "Print the module's logo: it has none", [] { return std::string(); });
  CLI::Option * const echo = app.add_flag("--echo", "Print all options with their values")->group(SlicerGroup);
  app.add_option("--returnparameterfile", returnParameterFile, "File for the results, a line 'name = value' each")
    ->type_name("FILE")
    ->group(SlicerGroup);
  app
    .add_option("--processinformationaddress",
                "Not used: --progress slicer tells how far the program is on standard output")
    ->type_name("ADDRESS")
    ->group(SlicerGroup);
  app.callback([&app, echo] {
    if (*echo)
    {
      std::cout << app.config_to_str(true);
    }
  });
}
} // namespace tissue
