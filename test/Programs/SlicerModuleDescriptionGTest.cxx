/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/SlicerModuleDescription.h"

#include "Shared/CommandLine/OptionChecks.h"
#include "Shared/CommandLine/SlicerOptions.h"
#include "SlicerModule.h"

#include <array>

using namespace tissue;

namespace
{
/** Options of every kind. */
struct Example
{
  Example()
  {
    app.add_option("image", text, "An \"image\" & <more>")->required();
    app.add_option("mesh", text, "The mesh")->required()->type_name("FILE")->check(EndsIn(".vtp"));
    app.add_option("--table", text, "A table")->type_name("FILE")->check(EndsIn(".csv"))->group("Further");
    app.add_option("--report", text, "A report")->type_name("FILE")->check(EndsIn(".json"))->group("Further");
    app.add_option("--other", text, "A file")->type_name("FILE")->group("Further");
    app.add_option("--labels", text, "Labels")->type_name("FILE")->group("Further");
    app.add_option("--small", small, "A small number")->check(InRange(0.0, 1.0))->capture_default_str();
    app.add_option("--large", large, "A number of any size")->check(InRange(0.0, 1e12))->capture_default_str();
    app.add_option("--count", count, "A count")->check(InRange(0, 64))->capture_default_str();
    app.add_option("--channel", none, "A channel")->check(InRange(1, 9))->capture_default_str();
    app.add_option("--optional", count, "No default")->check(InRange(0, 64));
    app.add_option("--size", size, "A size")->delimiter(',');
    app.add_option("--numbers", numbers, "Numbers")->delimiter(',')->allow_extra_args(false);
    app.add_option("--words", words, "Words")->delimiter(',')->allow_extra_args(false);
    app.add_option("--layer", layer, "A choice")->check(CLI::IsMember({ "auto", "on" }))->capture_default_str();
    app.add_flag("--isDark,--dark", isDark, "A flag");
    app.add_flag("--closeGaps{0}", "A flag with a value")->check(InRange(0.0, 9.0));
    app.add_option("--progress", text, "Progress");
    app.add_flag("--quiet", isQuiet, "Say nothing");
    app.add_option("--secret", text, "Left out")->group("Secrets");
    app.add_option("--hidden", text, "Hidden")->group("");
    module.title = "Example";
    module.uses = { { "image", SlicerUse::Image },
                    { "--labels", SlicerUse::LabelImage },
                    { "Secrets", SlicerUse::LeftOut } };
    module.results = { { "numberOfCells", "integer", "Cells" } };
    AddSlicerOptions(app, module, returnFile);
  }

  /** What the program prints on this command line; the error, if there is one. */
  std::string
  Answer(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), "example");
    std::vector<char *> argv;
    for (std::string & argument : arguments)
    {
      argv.push_back(argument.data());
    }
    testing::internal::CaptureStdout();
    std::string error;
    try
    {
      isParsed = Parse(app, static_cast<int>(argv.size()), argv.data());
    }
    catch (const std::exception & problem)
    {
      error = problem.what();
    }
    return testing::internal::GetCapturedStdout() + error;
  }

  CLI::App                 app{ "An example", "example" };
  SlicerModule             module;
  std::string              text;
  std::string              layer = "auto";
  std::string              returnFile;
  double                   small = 1e-5;
  double                   large = 2.0;
  unsigned int             count = 4;
  unsigned int             none = 0;
  std::array<double, 3>    size{};
  std::vector<long>        numbers;
  std::vector<std::string> words;
  bool                     isDark = false;
  bool                     isQuiet = false;
  bool                     isParsed = false;
};
} // namespace

TEST(SlicerModuleDescription, HasATypeForEveryOption)
{
  const Example         example;
  const SlicerModuleXML module(DescribeSlicerModule(example.app, example.module));
  EXPECT_EQ(module.about.at("title"), "Example");
  const std::map<std::string, std::string> tags{ { "image", "image" },
                                                 { "mesh", "geometry" },
                                                 { "table", "table" },
                                                 { "report", "file" },
                                                 { "other", "file" },
                                                 { "labels", "image" },
                                                 { "small", "double" },
                                                 { "large", "double" },
                                                 { "count", "integer" },
                                                 { "channel", "string" },
                                                 { "optional", "string" },
                                                 { "size", "double-vector" },
                                                 { "numbers", "integer-vector" },
                                                 { "words", "string-vector" },
                                                 { "layer", "string-enumeration" },
                                                 { "isDark", "boolean" },
                                                 { "closeGaps", "string" },
                                                 { "progress", "string" },
                                                 { "numberOfCells", "integer" } };
  for (const auto & [name, tag] : tags)
  {
    EXPECT_EQ(module.Find(name).tag, tag) << name;
  }
  EXPECT_EQ(module.parameters.size(), tags.size());
  EXPECT_EQ(module.Find("image").attributes.at("type"), "any");
  EXPECT_EQ(module.Find("image").Text("description"), "An \"image\" & <more>");
  EXPECT_EQ(module.Find("labels").attributes.at("type"), "label");
  EXPECT_EQ(module.Find("report").Text("channel"), "output");
  EXPECT_EQ(module.Find("other").Text("channel"), "input");
  EXPECT_EQ(module.Find("mesh").attributes.at("fileExtensions"), ".vtp");
  EXPECT_EQ(module.Find("closeGaps").Text("label"), "Close gaps");
}

TEST(SlicerModuleDescription, HasDefaultsAndConstraintsThatSlicerCanShow)
{
  const Example         example;
  const SlicerModuleXML module(DescribeSlicerModule(example.app, example.module));
  EXPECT_EQ(module.Find("small").Text("default"), "0.00001");
  EXPECT_EQ(module.Find("small").Text("step"), "0.01");
  EXPECT_EQ(module.Find("count").Text("default"), "4");
  EXPECT_EQ(module.Find("count").Text("maximum"), "64");
  EXPECT_EQ(module.Find("count").Text("step"), "1");
  EXPECT_FALSE(module.Find("large").Has("constraints"));
  EXPECT_EQ(module.Find("channel").Text("default"), "");
  EXPECT_EQ(module.Find("layer").Elements(), (std::set<std::string>{ "auto", "on" }));
}

TEST(SlicerOptions, DescribeTheModuleWhateverElseIsRequired)
{
  Example example;
  EXPECT_EQ(example.Answer({ "--xml" }), DescribeSlicerModule(example.app, example.module) + "\n");
  EXPECT_FALSE(example.isParsed);
  EXPECT_EQ(Example().Answer({ "--logo" }), "\n");
}

TEST(SlicerOptions, AreTakenWithTheOthers)
{
  Example           example;
  const std::string echo = example.Answer({ "--processinformationaddress",
                                            "0x1234",
                                            "--returnparameterfile",
                                            "r.txt",
                                            "--closeGaps",
                                            "2.5",
                                            "--size",
                                            "1,2,3",
                                            "--numbers",
                                            "4, 5",
                                            "a.mha",
                                            "b.vtp",
                                            "--echo" });
  EXPECT_TRUE(example.isParsed) << echo;
  EXPECT_NE(echo.find("returnparameterfile=\"r.txt\""), std::string::npos) << echo;
  EXPECT_NE(echo.find("count=4"), std::string::npos) << echo;
  EXPECT_EQ(example.returnFile, "r.txt");
  EXPECT_EQ(example.size, (std::array<double, 3>{ 1.0, 2.0, 3.0 }));
  EXPECT_EQ(example.numbers, (std::vector<long>{ 4, 5 }));
  EXPECT_EQ(example.app.get_option("--closeGaps")->as<double>(), 2.5);
}

TEST(SlicerOptions, TakeNoFileForTheNumberOfAFlag)
{
  Example example;
  example.Answer({ "--closeGaps", "0.5.mha", "b.vtp" });
  EXPECT_TRUE(example.isParsed);
  EXPECT_EQ(example.app.get_option("--closeGaps")->as<double>(), 0.0);
  EXPECT_NE(Example().Answer({ "a.mha", "b.vtp", "--closeGaps", "10" }).find("out of range"), std::string::npos);
}
