// SPDX-License-Identifier: BSD-3-Clause
/// The program as a server: MPI and Kokkos start once, then every line of the standard input is one
/// command line. Most of a tiny run is the start of MPI, so this runs ten times as many of them.
///
///     serve_runs            one rank: every command in a process of its own, which may be sent a
///     signal mpirun -n N serve_runs    N ranks: one command after the other in these processes
///
/// A line is split by tabs: PREFIX SIGNAL AFTER LIMIT WORD... The command's output goes to
/// PREFIX.out and PREFIX.err; SIGNAL (0: none) is sent AFTER so many microseconds, and what runs
/// longer than LIMIT seconds is killed. On one rank words NAME=VALUE before the command are
/// variables of its environment, as for env(1). The answer is one line: "exit CODE SECONDS",
/// "signal NUMBER SECONDS" or "hang 0 SECONDS", with the seconds of processor.
#define main program_main
#include "main.cpp"  // NOLINT(bugprone-suspicious-include): its functions, without its main
#undef main

#include "base/gather.hpp"

#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace barreno {
namespace {

struct Request {
  std::string prefix;
  int signal = 0;
  long after = 0;  ///< [us]
  int limit = 0;   ///< [s]
  std::vector<std::string> words;
};

Request read_request(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> parts;
  for (std::string part; std::getline(stream, part, '\t');) parts.push_back(part);
  if (parts.size() < 5) {
    std::fprintf(stderr, "serve_runs: a request needs five parts: %s\n", line.c_str());
    std::exit(1);
  }
  return {
      parts[0],
      std::stoi(parts[1]),
      std::stol(parts[2]),
      std::stoi(parts[3]),
      {parts.begin() + 4, parts.end()}};
}

void send_output_to(const std::string& prefix) {
  constexpr mode_t mode = 0644;
  for (const auto& [stream, ending] : {std::pair(1, ".out"), std::pair(2, ".err")}) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg)
    const int file = open((prefix + ending).c_str(), O_WRONLY | O_CREAT | O_APPEND, mode);
    if (file < 0 || dup2(file, stream) < 0) std::exit(1);
    close(file);
  }
}

/// Words NAME=VALUE before the command go into the environment of this process.
void take_variables(std::vector<std::string>& words) {
  while (!words.empty() && words.front().find('=') != std::string::npos) {
    const std::size_t sign = words.front().find('=');
    setenv(words.front().substr(0, sign).c_str(), words.front().c_str() + sign + 1, 1);
    words.erase(words.begin());
  }
}

int execute_request(const Request& request, const Teuchos::RCP<const Comm>& comm) {
  std::string program = "barreno";
  std::vector<char*> words{program.data()};
  std::vector<std::string> copies = request.words;
  for (std::string& word : copies) words.push_back(word.data());
  words.push_back(nullptr);
  const int code = report_errors(static_cast<int>(words.size()) - 1, words.data(), comm);
  std::cout << std::flush;
  std::cerr << std::flush;
  std::fflush(nullptr);
  return code;
}

double seconds_of(const rusage& usage) {
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Waits for a child, sends it its signal, and kills it at the limit. @return the answer
std::string watch(pid_t child, const Request& request) {
  using clock = std::chrono::steady_clock;
  const auto begun = clock::now();
  const auto due = begun + std::chrono::microseconds(request.after);
  const auto end = begun + std::chrono::seconds(request.limit);
  bool sent = request.signal == 0;
  bool hangs = false;
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, WNOHANG, &usage) == 0) {
    if (!sent && clock::now() >= due) {
      kill(child, request.signal);
      sent = true;
    }
    if (!hangs && clock::now() >= end) {
      hangs = true;
      kill(child, SIGKILL);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  std::ostringstream answer;
  if (hangs)
    answer << "hang 0 ";
  else if (WIFSIGNALED(status))
    answer << "signal " << WTERMSIG(status) << ' ';
  else
    answer << "exit " << WEXITSTATUS(status) << ' ';
  answer << seconds_of(usage) << '\n';
  return answer.str();
}

std::string in_own_process(Request request, const Teuchos::RCP<const Comm>& comm) {
  const pid_t child = fork();
  if (child < 0) return "hang 0 0\n";
  if (child > 0) return watch(child, request);
  send_output_to(request.prefix);
  take_variables(request.words);
  // MPI and Kokkos belong to the parent: nothing is taken down here.
  _exit(execute_request(request, comm));
}

std::string on_all_ranks(const Request& request, const Teuchos::RCP<const Comm>& comm) {
  send_output_to(request.prefix);
  alarm(static_cast<unsigned>(request.limit));
  const std::clock_t begun = std::clock();
  const int code = execute_request(request, comm);
  alarm(0);
  std::ostringstream answer;
  answer << "exit " << code << ' '
         << static_cast<double>(std::clock() - begun) / static_cast<double>(CLOCKS_PER_SEC) << '\n';
  return answer.str();
}

/// Until the root has something to do, without the processor that a broadcast would wait with.
void await_root() {
  MPI_Request arrived{};
  MPI_Ibarrier(MPI_COMM_WORLD, &arrived);
  for (int all = 0; all == 0; MPI_Test(&arrived, &all, MPI_STATUS_IGNORE))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

int serve(const Teuchos::RCP<const Comm>& comm) {
  const int answers = dup(1);
  while (true) {
    std::string line;
    if (is_root(*comm)) std::getline(std::cin, line);
    await_root();
    line = broadcast_from_root(*comm, line);
    if (line.empty()) return 0;
    const Request request = read_request(line);
    const std::string answer =
        comm->getSize() == 1 ? in_own_process(request, comm) : on_all_ranks(request, comm);
    if (is_root(*comm) && write(answers, answer.data(), answer.size()) < 0) return 1;
  }
}

}  // namespace
}  // namespace barreno

int main(int argc, char** argv) {
  const Tpetra::ScopeGuard mpi_and_kokkos(&argc, &argv);
  return barreno::serve(Tpetra::getDefaultComm());
}
