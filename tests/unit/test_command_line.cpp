// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "command_line.hpp"
#include "command_pages.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace barreno {
namespace {

using Words = std::vector<std::string>;

Options parse(const Words& words) {
  std::vector<const char*> argv{"barreno"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  return parse_command_line(static_cast<int>(argv.size()), argv.data());
}

std::string refusal(const Words& words) {
  try {
    parse(words);
  } catch (const DeckError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CommandLine, ReadsARunWithItsOptionsInAnyOrder) {
  const Options options = parse(
      {"run",
       "--set",
       "Time/End Time=5 us",
       "deck.xml",
       "--fidelity=fast",
       "--ranks",
       "3",
       "--set",
       "Grid/Cell Size=",
       "--overwrite",
       "--out",
       "a folder"}
  );
  EXPECT_EQ(options.command, Command::run);
  EXPECT_EQ(options.deck_file, "deck.xml");
  EXPECT_EQ(options.out, "a folder");
  EXPECT_EQ(options.ranks, 3);
  EXPECT_TRUE(options.overwrite);
  // In the order in which they were typed: later ones win.
  EXPECT_EQ(options.overrides, (Words{"Time/End Time=5 us", "Fidelity=fast", "Grid/Cell Size="}));
}

TEST(CommandLine, ReadsTheOtherCommands) {
  const Options resume = parse({"resume", "runs/a-1", "--until", "200 us"});
  EXPECT_EQ(resume.command, Command::resume);
  EXPECT_EQ(resume.deck_file, "runs/a-1");
  EXPECT_EQ(resume.overrides, Words{"Time/End Time=200 us"});
  const Options stage =
      parse({"continue", "/runs/a-1", "--deck", "b.xml", "--at-rest", "--set", "A/B=1"});
  EXPECT_EQ(stage.command, Command::continue_run);
  EXPECT_EQ(stage.deck_file, "b.xml");
  EXPECT_EQ(
      stage.overrides, (Words{"Continue/Run=/runs/a-1", "Continue/Velocities=at rest", "A/B=1"})
  );
  EXPECT_EQ(parse({"check", "run"}).deck_file, "run");  // a deck may have a command's name
  const Options drive = parse(
      {"drive",
       "--material",
       "a",
       "--path",
       "b",
       "--out",
       "c",
       "--steps-per-row",
       "7",
       "--every-step",
       "--plot",
       "d.png",
       "--set",
       "K=1"}
  );
  EXPECT_EQ(drive.drive.material + drive.drive.path + drive.drive.out, "abc");
  EXPECT_EQ(drive.drive.steps.per_row, 7);
  EXPECT_TRUE(drive.drive.steps.every);
  EXPECT_EQ(drive.drive.picture, "d.png");
  EXPECT_FALSE(parse({"drive", "--material", "a", "--path", "b", "--out", "c"}).drive.steps.every);
  EXPECT_EQ(drive.drive.overrides, Words{"K=1"});
  const Options describe = parse({"describe", "Grid", "--markdown"});
  EXPECT_EQ(describe.section, "Grid");
  EXPECT_TRUE(describe.markdown);
  EXPECT_EQ(parse({"describe"}).section, "");
}

TEST(CommandLine, GivesHelpAndVersion) {
  EXPECT_EQ(parse({}).command, Command::help);
  for (const char* word : {"-h", "--help", "help"}) {
    EXPECT_EQ(parse({word}).command, Command::help);
    EXPECT_EQ(parse({word}).help_of, Command::help);
  }
  for (const char* word : {"--version", "version"})
    EXPECT_EQ(parse({word}).command, Command::version);
  for (const CommandPage& page : command_pages())
    for (const char* word : {"-h", "--help"}) {
      const Options options = parse({page.name, word});
      EXPECT_EQ(options.command, Command::help) << page.name;
      EXPECT_EQ(options.help_of, page.command) << page.name;
    }
}

TEST(CommandLine, HelpNamesEveryCommandAndOption) {
  const std::string all = help_text();
  for (const CommandPage& page : command_pages()) {
    const std::string one = help_text(page.command);
    EXPECT_NE(one.find(std::string("barreno ") + page.name + " "), std::string::npos) << one;
    EXPECT_NE(all.find(std::string("\n") + page.name + "\n"), std::string::npos) << all;
    for (const OptionPage& option : page.options)
      for (const std::string& text : {one, all})
        EXPECT_NE(text.find(option.name), std::string::npos) << option.name << " in\n" << text;
    EXPECT_NE(one.find("Exit codes: 0 finished"), std::string::npos) << one;
  }
}

TEST(CommandLine, RefusesWhatItDoesNotKnowWithTheNearestName) {
  const std::pair<Words, const char*> refusals[] = {
      {{"rnu", "deck.xml"}, "\"rnu\" is not a command; did you mean 'run'?"},
      {{"rnu", "--help"}, "\"rnu\" is not a command"},
      {{"report", "x"}, "report is a command of ./barreno in the source tree"},
      {{"converge", "x"}, "write ./barreno converge DECK."},
      {{"sweep", "x"}, "write ./barreno sweep DECK --vary"},
      {{"compare", "x"}, "write ./barreno compare RUN RUN."},
      {{"run", "deck.xml", "--overwrit"},
       "--overwrit is not an option of this command; did you mean '--overwrite'?"},
      {{"check", "deck.xml", "--until", "1 s"}, "--until is not an option of this command"},
      {{"run", "deck.xml", "--outt=x"}, "did you mean '--out'?"},
      {{"run", "deck.xml", "--fidelity", "fats"}, "did you mean 'fast'?"}};
  for (const auto& [words, sentence] : refusals)
    EXPECT_NE(refusal(words).find(sentence), std::string::npos) << refusal(words);
}

TEST(CommandLine, RefusesWhatIsMissingOrTooMuch) {
  const std::pair<Words, const char*> refusals[] = {
      {{"run"}, "the deck file is missing"},
      {{"check", ""}, "the deck file is missing"},
      {{"continue"}, "the folder of the finished run is missing"},
      {{"continue", "runs/a-1"}, "--deck is missing"},
      {{"resume"}, "the run folder, which holds the checkpoint, is missing"},
      {{"run", "a.xml", "b.xml"}, "\"b.xml\" follows \"a.xml\""},
      {{"run", "a.xml", "--out"}, "--out needs a value"},
      {{"run", "a.xml", "--out", ""}, "--out needs a value"},
      {{"run", "a.xml", "--out", "--overwrite"}, "--out needs a value"},
      {{"run", "a.xml", "--ranks", "0"}, "--ranks 0 is not a number of ranks"},
      {{"run", "a.xml", "--ranks", "2x"}, "is not a number of ranks"},
      {{"drive", "good.csv"}, "\"good.csv\" is not preceded by an option"},
      {{"drive", "--material", "a", "--path", "b"}, "--out is missing"},
      {{"run", "a.xml", "--overwrite=yes"}, "--overwrite takes no value"}};
  for (const auto& [words, sentence] : refusals)
    EXPECT_NE(refusal(words).find(sentence), std::string::npos) << refusal(words);
}

}  // namespace
}  // namespace barreno
