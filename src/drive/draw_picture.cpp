// SPDX-License-Identifier: BSD-3-Clause
#include "drive/draw_picture.hpp"

#include "base/error.hpp"
#include "files/installed_file.hpp"
#include "files/text_file.hpp"

#include <barreno/input/scan_xml.hpp>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <spawn.h>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace barreno {
namespace {

namespace fs = std::filesystem;
constexpr const char* script_name = "plot_drive.py";
constexpr const char* install_line =
    "apt-get install --no-install-recommends python3 python3-numpy python3-matplotlib";

/// A file without a name, which is gone when it is closed.
using Scratch = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void refuse_picture(
    const std::string& picture, const std::string& reason, const std::string& advice
) {
  throw FileError(
      "--plot " + input::shown(picture) + " cannot be drawn (" + reason + "); " + advice + "."
  );
}

Scratch scratch_file(const std::string& picture) {
  Scratch file(std::tmpfile(), &std::fclose);
  if (!file) {
    refuse_picture(
        picture, std::string("no temporary file: ") + std::strerror(errno), "free the disk of /tmp"
    );
  }
  return file;
}

std::string find_script() {
  return installed_file(
             {BARRENO_PLOT_IN_PREFIX, BARRENO_PLOT_FOLDER, BARRENO_INSTALLED_PLOT_FOLDER},
             script_name
  )
      .string();
}

/// The one that the user names, or the distribution's own, which has its packages; another one only
/// where that is missing.
std::string find_python() {
  if (const char* const named = std::getenv("BARRENO_PYTHON")) return named;
  const char* const own = "/usr/bin/python3";
  return access(own, X_OK) == 0 ? own : "python3";
}

/// Exit code of a program that reads one file and says what is wrong to the other.
/// @param[out] problem  why it could not be started: an errno, or 0
int run_program(std::vector<std::string> words, std::FILE* in, std::FILE* said, int& problem) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(said), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(said), STDERR_FILENO);
  pid_t child = 0;
  problem = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), ::environ);
  posix_spawn_file_actions_destroy(&actions);
  if (problem != 0) return -1;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The last line that was said, in one piece.
std::string last_line(std::FILE* said) {
  std::rewind(said);
  std::string text;
  char part[4096];
  for (std::size_t got = 0; (got = std::fread(part, 1, sizeof part, said)) > 0;)
    text.append(part, got);
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  constexpr std::size_t longest = 300;
  return cut_text(last, longest);
}

}  // namespace

void check_picture_name(const std::string& picture) {
  const std::string ending = fs::path(picture).extension().string();
  if (ending == ".png" || ending == ".pdf" || ending == ".svg") return;
  throw DeckError(
      "--plot " + input::shown(picture) +
      " is not the name of a picture (it ends with .png, .pdf or .svg); write for example --plot "
      "answer.png."
  );
}

std::string surface_file_of(const std::string& picture) {
  const fs::path path(picture);
  return (path.parent_path() / (path.stem().string() + "_surface.csv")).string();
}

void draw_picture(const std::string& picture, const std::string& text) {
  const std::string script = find_script();
  if (script.empty()) {
    refuse_picture(
        picture,
        std::string(script_name) + " of Barreno is neither beside the program nor in " +
            BARRENO_PLOT_FOLDER,
        "install Barreno with cmake --install"
    );
  }
  const Scratch in = scratch_file(picture), said = scratch_file(picture);
  const bool whole = std::fwrite(text.data(), 1, text.size(), in.get()) == text.size();
  if (!whole || std::fflush(in.get()) != 0)
    refuse_picture(picture, "the disk of /tmp is full", "free it");
  std::rewind(in.get());
  int problem = 0;
  const int code = run_program({find_python(), script, picture}, in.get(), said.get(), problem);
  if (problem != 0) {
    refuse_picture(
        picture,
        std::string("it needs Python 3 with Matplotlib, and python3 does not start: ") +
            std::strerror(problem),
        std::string("install it: ") + install_line
    );
  }
  constexpr int no_module = 3;  // of plot_drive.py
  if (code == no_module)
    refuse_picture(picture, last_line(said.get()), std::string("install it: ") + install_line);
  if (code != 0) refuse_picture(picture, last_line(said.get()), "mend that, or leave --plot out");
}

}  // namespace barreno
