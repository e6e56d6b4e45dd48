// SPDX-License-Identifier: BSD-3-Clause
#include "drive/drive.hpp"

#include "base/error.hpp"
#include "deck/files/load_material.hpp"
#include "deck/files/read_on_root.hpp"
#include "drive/drive_mixed.hpp"
#include "drive/drive_point.hpp"
#include "drive/mixed_path.hpp"
#include "output/text_file.hpp"

#include <barreno/input/scan_xml.hpp>
#include <filesystem>
#include <sstream>
#include <variant>
#include <vector>

namespace barreno {
namespace {

const char* model_of(const Material& material) {
  return std::visit([](const auto& model) { return model.name; }, material.model);
}
/// That of the form which the parameters need.
std::vector<HistoryField> history_of(const Material& material) {
  return std::visit([](const auto& model) { return model.history_table(); }, material.model);
}

/// @param motion  its unit, and the frame of the stress
std::string units_line(const Material& material, const char* motion, const char* frame) {
  std::string line = std::string("# SI units: time s; ") + motion +
                     "; stress Pa, Cauchy, tension positive, in the " + frame;
  for (const HistoryField& field : history_of(material)) {
    const std::string unit = input::si_unit_of(field.dimension);
    line += std::string("; ") + field.name + " " + (unit.empty() ? "-" : unit);
  }
  return line;
}

std::string column_line(const Material& material, const char* motion) {
  std::string line = std::string("time,") + motion +
                     ",stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx";
  for (const HistoryField& field : history_of(material)) line += std::string(",") + field.name;
  return line;
}

std::string row_line(const PathRow& instant, const DrivenRow& row) {
  std::vector<double> values{instant.time};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) values.push_back(instant.deformation_gradient(i, j));
  const Sym3& s = row.stress;
  values.insert(values.end(), {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx});
  values.insert(values.end(), row.history.begin(), row.history.end());
  return csv_line(values);
}

std::string table_text(
    const Material& material, const std::vector<PathRow>& path, const std::vector<DrivenRow>& rows
) {
  std::string text = units_line(material, "F -", "space frame") + "\n" +
                     column_line(material, "F11,F12,F13,F21,F22,F23,F31,F32,F33") + "\n";
  for (std::size_t i = 0; i < rows.size(); ++i) text += row_line(path[i], rows[i]) + "\n";
  return text;
}

std::string mixed_text(
    const Material& material, const MixedPath& path, const std::vector<MixedAnswer>& answers
) {
  std::string text =
      units_line(material, "strain -, logarithmic", "axes of the material") + "\n" +
      column_line(material, "strain_xx,strain_yy,strain_zz,strain_xy,strain_yz,strain_zx") + "\n";
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const MixedAnswer& answer = answers[i];
    std::vector<double> values{path.rows[i].time};
    for (const Sym3& s : {answer.strain, answer.stress})
      values.insert(values.end(), {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx});
    values.insert(values.end(), answer.history.begin(), answer.history.end());
    text += csv_line(values) + "\n";
  }
  return text;
}

struct Driven {
  std::string table;
  std::size_t rows = 0;
};
/// By the kind of path that the text is.
Driven drive_along(
    const Material& material, const std::string& text, int steps, const std::string& name
) {
  if (is_mixed_path(text)) {
    const MixedPath path = read_mixed_path(text, name);
    return {mixed_text(material, path, drive_mixed(material, path, steps, name)), path.rows.size()};
  }
  const std::vector<PathRow> path = read_path(text, name);
  return {table_text(material, path, drive_point(material, path, steps, name)), path.size()};
}

/// An answer must not replace what was asked.
void check_out(const DriveRequest& request) {
  std::error_code ignored;  // a file that does not exist cannot be an input
  for (const std::string& input : {request.path, request.material}) {
    if (!std::filesystem::equivalent(request.out, input, ignored)) continue;
    throw DeckError(
        "--out " + input::shown(request.out) +
        " is an input of this command (it would be overwritten); give another file."
    );
  }
}

void write(const DriveRequest& request, const std::string& text, const Comm& comm) {
  RootWork work(comm);
  work.run([&] {
    if (goes_to_stream(request))
      write_into(request.out, text);
    else
      write_whole_file(request.out, text);
  });
  work.agree();
}

}  // namespace

bool goes_to_stream(const DriveRequest& request) {
  for (const char* folder : {"/dev/", "/proc/"})
    if (request.out.rfind(folder, 0) == 0) return true;
  std::error_code ignored;
  const auto status = std::filesystem::status(request.out, ignored);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
         !std::filesystem::is_directory(status);
}

std::string drive(const DriveRequest& request, const Comm& comm) {
  check_out(request);
  const auto [material, notes] = load_material(request.material, request.overrides, comm);
  const auto read = [&] { return read_file(request.path, input::largest_text, "a path"); };
  const std::string name = std::filesystem::path(request.path).filename().string();
  const Driven driven =
      drive_along(material, read_on_root(read, comm), request.steps_per_row, name);
  write(request, driven.table, comm);

  std::ostringstream screen;
  for (const std::string& note : notes) screen << "note: " << note << '\n';
  screen << model_of(material) << " of '" << material.name
         << "': " << counted(static_cast<double>(driven.rows), "rows") << ", "
         << counted(request.steps_per_row, "steps between two") << ", in " << request.out << '\n';
  return screen.str();
}

}  // namespace barreno
