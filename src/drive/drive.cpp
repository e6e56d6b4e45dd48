// SPDX-License-Identifier: BSD-3-Clause
#include "drive/drive.hpp"

#include "base/error.hpp"
#include "deck/files/load_material.hpp"
#include "deck/files/read_on_root.hpp"
#include "drive/draw_picture.hpp"
#include "drive/driven_state.hpp"
#include "drive/mixed_path.hpp"
#include "drive/plot_text.hpp"
#include "drive/yield_table.hpp"
#include "files/text_file.hpp"

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

std::string row_line(const DrivenRow& row) {
  std::vector<double> values{row.time};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) values.push_back(row.deformation_gradient(i, j));
  const Sym3& s = row.stress;
  values.insert(values.end(), {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx});
  values.insert(values.end(), row.history.begin(), row.history.end());
  return csv_line(values);
}

std::string row_line(const MixedAnswer& answer) {
  std::vector<double> values{answer.time};
  for (const Sym3& s : {answer.strain, answer.stress})
    values.insert(values.end(), {s.xx, s.yy, s.zz, s.xy, s.yz, s.zx});
  values.insert(values.end(), answer.history.begin(), answer.history.end());
  return csv_line(values);
}

struct Driven {
  std::string table;
  std::size_t rows = 0;
  std::vector<DrivenState> states;  ///< every step, where there is to be a picture
  std::vector<std::string> notes;   ///< of the path, a sentence each
};

/// A picture knows of every step, the table of every `stride`-th.
template <class Row>
Driven driven(const DriveRequest& request, const std::vector<Row>& rows, const std::string& head) {
  const bool thinned = !request.steps.every && !request.picture.empty();
  const std::size_t stride = thinned ? static_cast<std::size_t>(request.steps.per_row) : 1;
  Driven result;
  result.table = head;
  for (std::size_t i = 0; i < rows.size(); i += stride, ++result.rows)
    result.table += row_line(rows[i]) + "\n";
  if (!request.picture.empty()) result.states = states_of(rows);
  return result;
}

/// By the kind of path that the text is.
Driven drive_along(
    const Material& material,
    const std::string& text,
    const DriveRequest& request,
    const std::string& name
) {
  const DriveSteps steps{request.steps.per_row, request.steps.every || !request.picture.empty()};
  const auto head = [&](const char* motion, const char* frame, const char* columns) {
    return units_line(material, motion, frame) + "\n" + column_line(material, columns) + "\n";
  };
  if (is_mixed_path(text, name)) {
    const MixedPath path = read_mixed_path(text, name);
    Driven answer = driven(
        request,
        drive_mixed(material, path, steps, name),
        head(
            "strain -, logarithmic",
            "axes of the material",
            "strain_xx,strain_yy,strain_zz,strain_xy,strain_yz,strain_zx"
        )
    );
    answer.notes = path.notes;
    return answer;
  }
  std::vector<std::string> notes;
  const std::vector<PathRow> path = read_path(text, name, &notes);
  Driven answer = driven(
      request,
      drive_point(material, path, steps, name),
      head("F -", "space frame", "F11,F12,F13,F21,F22,F23,F31,F32,F33")
  );
  answer.notes = notes;
  return answer;
}

/// An answer must not replace what was asked.
void check_no_input(
    const DriveRequest& request, const std::string& option, const std::string& file
) {
  std::error_code ignored;  // a file that does not exist cannot be an input
  for (const std::string& input : {request.path, request.material}) {
    if (!std::filesystem::equivalent(file, input, ignored)) continue;
    throw DeckError(
        option + input::shown(file) +
        " is an input of this command (it would be overwritten); give another file."
    );
  }
}

void check_files(const DriveRequest& request) {
  check_no_input(request, "--out ", request.out);
  if (request.picture.empty()) return;
  check_picture_name(request.picture);
  const auto place = [](const std::string& file) {
    return std::filesystem::absolute(file).lexically_normal();
  };
  for (const std::string& file : {request.picture, surface_file_of(request.picture)}) {
    check_no_input(request, "--plot with its table ", file);
    if (place(file) != place(request.out)) continue;
    throw DeckError(
        "--plot writes " + input::shown(file) +
        ", which is the file of --out (one would overwrite the other); give another name."
    );
  }
}

/// The picture first: where it cannot be drawn nothing is written.
void write(
    const DriveRequest& request,
    const Driven& driven,
    const std::string& plot,
    const std::string& surface,
    const Comm& comm
) {
  RootWork work(comm);
  work.run([&] {
    if (!request.picture.empty()) draw_picture(request.picture, plot);
    if (!surface.empty()) write_whole_file(surface_file_of(request.picture), surface);
    if (goes_to_stream(request))
      write_into(request.out, driven.table);
    else
      write_whole_file(request.out, driven.table);
  });
  work.agree();
}

std::string screen_text(
    const DriveRequest& request, const Material& material, std::size_t rows, bool surface
) {
  std::ostringstream screen;
  screen << model_of(material) << " of '" << material.name
         << "': " << counted(static_cast<double>(rows), "rows") << ", ";
  if (request.steps.every) screen << "one for each step, ";
  screen << counted(request.steps.per_row, "steps between two");
  if (request.steps.every) screen << " of the path";
  screen << ", in " << request.out << '\n';
  if (!request.picture.empty()) screen << "picture in " << request.picture;
  if (surface) screen << ", its yield surface in " << surface_file_of(request.picture);
  if (!request.picture.empty()) screen << '\n';
  return screen.str();
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
  check_files(request);
  const auto [material, notes] = load_material(request.material, request.overrides, comm);
  const auto read = [&] { return read_file(request.path, input::largest_text, "a path"); };
  const std::string name = std::filesystem::path(request.path).filename().string();
  const Driven driven = drive_along(material, read_on_root(read, comm), request, name);
  std::string plot, surface;
  if (!request.picture.empty()) {
    surface = yield_table(material, driven.states);
    plot = plot_text(material, driven.states, surface, name);
  }
  write(request, driven, plot, surface, comm);

  std::string screen;
  for (const std::string& note : notes) screen.append("note: ").append(note).append("\n");
  for (const std::string& note : driven.notes)
    screen.append("note: ").append(name).append(": ").append(note).append("\n");
  return screen + screen_text(request, material, driven.rows, !surface.empty());
}

}  // namespace barreno
