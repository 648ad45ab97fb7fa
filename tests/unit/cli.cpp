// Parsing of the command line, without running a command.
#include "commands/cli.h"

#include <gtest/gtest.h>

#include <sstream>

namespace laver::test {
namespace {

Job jobOf(const std::string& arguments) {
  std::istringstream in("laver " + arguments);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  return parse(static_cast<int>(argv.size()), argv.data());
}

template <class Command>
Command commandOf(const std::string& arguments) {
  return std::get<Command>(jobOf(arguments));
}

std::string errorOf(const std::string& arguments) {
  try {
    jobOf(arguments);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::Usage);
    return error.what();
  }
  return "no error";
}

TEST(Cli, EachSubcommandIsAJob) {
  EXPECT_EQ(commandOf<RenderCommand>("a.xml -o b.exr").output, "b.exr");
  EXPECT_EQ(commandOf<ViewCommand>("a.exr").a, "a.exr");
  EXPECT_EQ(commandOf<ViewCommand>("view a.exr b.exr").b, "b.exr");
  EXPECT_EQ(commandOf<CompareCommand>("compare a.exr b.exr").tolerance, std::nullopt);
  EXPECT_EQ(commandOf<CompareCommand>("compare a.exr b.exr --tolerance 0").tolerance, 0.0);
  EXPECT_EQ(commandOf<ExplainCommand>("explain a.xml --traversal lane").vulkan.traversal, "lane");
  EXPECT_EQ(commandOf<ExplainCommand>("explain a.xml --size 3x4").overrides.size, glm::ivec2(3, 4));
  EXPECT_TRUE(commandOf<PlanCommand>("plan a.xml --json").json);
  EXPECT_EQ(commandOf<TestCommand>("test folder --jobs 3").jobs, 3U);
  EXPECT_EQ(commandOf<ChartCommand>("chart a.xml --runs 3").runs, 3U);
  EXPECT_TRUE(commandOf<SchemaCommand>("schema --json").json);
  EXPECT_TRUE(commandOf<SchemaCommand>("schema --markdown").markdown);
  commandOf<DevicesCommand>("devices");
  EXPECT_EQ(commandOf<HelpCommand>("--version").text.rfind("laver ", 0), 0U);
}

TEST(Cli, StatsGoToStandardErrorOrAFile) {
  EXPECT_EQ(commandOf<RenderCommand>("a.xml").stats, "");
  EXPECT_EQ(commandOf<RenderCommand>("--stats a.xml").stats, RenderCommand::kToStderr);
  EXPECT_EQ(commandOf<RenderCommand>("--stats=f.json a.xml").stats, "f.json");
}

TEST(Cli, TheFirstIntegratorReplacesTheScenesAndOthersAreLayers) {
  const auto command = commandOf<RenderCommand>("--integrator depth,normals,av a.xml");
  ASSERT_TRUE(command.overrides.integrator);
  EXPECT_STREQ(command.overrides.integrator->row->name, "depth");
  ASSERT_EQ(command.options.more.size(), 2U);
  EXPECT_STREQ(command.options.more[1].row->name, "av");
  EXPECT_EQ(command.scene, "a.xml");
}

TEST(Cli, SizesAndCropsAreNumbers) {
  const auto command = commandOf<RenderCommand>("--size 40x30 --crop 3,4,13,24 a.xml");
  EXPECT_EQ(command.overrides.size, glm::ivec2(40, 30));
  ASSERT_TRUE(command.options.crop);
  EXPECT_EQ(command.options.crop->x0, 3);
  EXPECT_EQ(command.options.crop->y1, 24);
}

TEST(Cli, NoGuiWinsInAnyOrder) {
  EXPECT_TRUE(commandOf<RenderCommand>("a.xml --gui").gui);
  for (const char* arguments : {"a.xml --gui -b", "a.xml --nogui --gui", "--no-gui a.xml --gui"})
    EXPECT_FALSE(commandOf<RenderCommand>(arguments).gui) << arguments;
}

TEST(Cli, ErrorsSayWhatWasExpected) {
  EXPECT_EQ(errorOf(""), "no scene given; see laver --help");
  EXPECT_EQ(errorOf("a.xml --size 12x"),
            "--size: expected WIDTHxHEIGHT, both above 0, not \"12x\"");
  EXPECT_EQ(errorOf("a.xml --size 1x2x3"),
            "--size: expected WIDTHxHEIGHT, both above 0, not \"1x2x3\"");
  EXPECT_EQ(errorOf("a.xml --crop 1,2,3"), "--crop: expected x0,y0,x1,y1, not \"1,2,3\"");
  EXPECT_EQ(errorOf("a.xml --sampler halton"),
            "--sampler: expected independent, stratified or sobol, not \"halton\"");
  EXPECT_EQ(errorOf("a.xml --integrator depth,halton"),
            "--integrator: expected " + namesOf(integratorRows()) +
                ", or a file FILE.glsl, not \"halton\"");
  EXPECT_EQ(errorOf("a.xml --layers id,id"), "--layers: id is named twice");
  EXPECT_EQ(errorOf("a.xml --display-server x:y"),
            "--display-server x:y: expected HOST:PORT or [IPV6]:PORT");
  EXPECT_EQ(errorOf("compare a.exr"), "B.exr is required");
  EXPECT_NE(errorOf("schema --json --markdown"), "no error");
  EXPECT_EQ(errorOf("explain"), "SCENE.xml is required");
  EXPECT_EQ(errorOf("plan a.xml b.xml"), "unexpected argument b.xml; see laver plan --help");
  EXPECT_EQ(errorOf("explain a.xml --spp 4"),
            "unexpected argument --spp; see laver explain --help");
  EXPECT_EQ(errorOf("a.xml --sppp 4"), "unexpected argument --sppp; see laver --help");
}

TEST(Cli, SizesAreAboveZero) {
  for (const char* size : {"0x0", "0x5", "5x00"})
    EXPECT_NE(
        errorOf(std::string("a.xml --size ") + size).find("expected WIDTHxHEIGHT, both above 0"),
        std::string::npos);
  EXPECT_EQ(commandOf<RenderCommand>("a.xml --size 064x9").overrides.size, glm::ivec2(64, 9));
}

TEST(Cli, EmptyNamesAreRefused) {
  for (const std::vector<const char*>& words :
       {std::vector<const char*>{"laver", "a.xml", "-o", ""},
        {"laver", "chart", "a.xml", "--out", ""},
        {"laver", "compare", "a.exr", "b.exr", "--out="}}) {
    try {
      parse(static_cast<int>(words.size()), words.data());
      ADD_FAILURE() << words[1];
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::Usage);
      EXPECT_NE(std::string(error.what()).find("--out"), std::string::npos) << error.what();
    }
  }
}

TEST(Cli, HelpListsTheTablesNames) {
  const std::string help = commandOf<HelpCommand>("--help").text;
  for (const IntegratorRow* row : integratorRows())
    EXPECT_NE(help.find(row->name), std::string::npos) << row->name;
  for (const LayerRow* row : layerRows())
    EXPECT_NE(help.find(row->name), std::string::npos) << row->name;
  for (const char* name : {"stratified or sobol", "tent or box", "zaragoza or nori1"})
    EXPECT_NE(help.find(name), std::string::npos) << name;
  EXPECT_NE(commandOf<HelpCommand>("explain --help").text.find("--traversal"), std::string::npos);
}

}  // namespace
}  // namespace laver::test
