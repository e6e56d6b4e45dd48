// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/read_surface.hpp"

#include "base/error.hpp"
#include "deck/files/stl_text.hpp"

#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace barreno {
namespace {

// Only those parts of CGAL that are under the LGPL: its reader and its points.
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Triangle = std::array<std::size_t, 3>;

struct Soup {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

[[noreturn]] void refuse(const std::string& source, const std::string& problem) {
  throw DeckError(source + " " + problem + ".");
}

/// A binary file has 80 bytes of any text, the number of facets, and 50 bytes for each of them.
constexpr std::size_t header_bytes = 84, facet_bytes = 50;

std::size_t announced_facets(const std::string& text) {
  std::uint32_t count = 0;
  std::memcpy(&count, text.data() + header_bytes - sizeof count, sizeof count);
  return count;
}

/// What begins with "solid" is text, unless its size is just that of the facets that it announces.
bool is_binary(const std::string& text, const std::string& source) {
  if (text.compare(0, 2, "\xFF\xFE") == 0 || text.compare(0, 2, "\xFE\xFF") == 0)
    refuse(source, "is text in UTF-16 (STL files are in ASCII); save it as plain text");
  if (text.size() < header_bytes) return false;
  const std::size_t facets = announced_facets(text);
  const std::size_t size = header_bytes + facets * facet_bytes;
  if (size == text.size()) return true;
  if (begins_as_stl_text(text)) return false;
  if (size > text.size())
    refuse(
        source,
        "is not a complete STL file (it announces " + std::to_string(facets) +
            " facets, which take " + std::to_string(size) + " bytes, but has " +
            std::to_string(text.size()) + "); export it again"
    );
  return true;
}

Soup read_soup(const std::string& text, const std::string& source) {
  Soup soup;
  std::istringstream stream;
  // The reader takes a header that begins with "solid" for text.
  if (is_binary(text, source))
    stream.str(std::string(5, '-') + text.substr(5));
  else if (begins_as_stl_text(text))
    stream.str(plain_stl_text(text, source));
  bool sound = false;
  try {
    sound = CGAL::IO::read_STL(stream, soup.points, soup.triangles);
  } catch (const std::exception&) {
    sound = false;
  }
  if (!sound || soup.triangles.empty())
    refuse(
        source,
        "is not a complete STL file (neither as text from solid to endsolid nor in binary); export "
        "it again"
    );
  return soup;
}

std::string counted(long count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void check_sound(const Surface& surface, const std::string& source) {
  const SurfaceFaults faults = faults_of(surface);
  if (faults.open_edges > 0)
    refuse(
        source,
        "has " + counted(faults.open_edges, "open edge", "open edges") +
            " (a solid needs a closed surface); close its holes where it was made"
    );
  if (faults.branching_edges > 0)
    refuse(
        source,
        "has " + counted(faults.branching_edges, "edge where", "edges where") +
            " more than two facets meet (inside and outside are not defined there); give every "
            "solid a surface of its own"
    );
  if (faults.flipped_facets > 0)
    refuse(
        source,
        "has " + counted(faults.flipped_facets, "flipped facet", "flipped facets") +
            " (neighbours disagree about which side is outside); make its normals agree where it "
            "was made"
    );
  if (faults.wrong_facets > 0)
    refuse(
        source,
        "has " + counted(faults.wrong_facets, "facet", "facets") +
            " without the inside on one side and the outside on the other (the surface is inside "
            "out or goes through itself); turn its normals outward or unite its parts where it was "
            "made"
    );
}

}  // namespace

std::shared_ptr<const Surface> read_surface(
    const std::string& text, double unit, const Vector& shift, const std::string& source
) {
  const Soup soup = read_soup(text, source);
  std::vector<Vector> points;
  for (const Point& p : soup.points) {
    points.push_back({p.x() * unit + shift[0], p.y() * unit + shift[1], p.z() * unit + shift[2]});
    for (const double x : points.back())
      if (!std::isfinite(x))
        refuse(source, "has a corner that is not a finite number; export it again");
  }
  std::vector<Surface::Facet> facets;
  for (const Triangle& t : soup.triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    facets.push_back({static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2])});
  }
  if (facets.empty()) refuse(source, "has no facet with an area; export it again");
  auto surface = std::make_shared<const Surface>(std::move(points), std::move(facets));
  check_sound(*surface, source);
  return surface;
}

}  // namespace barreno
