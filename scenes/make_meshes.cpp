// Writes the meshes of the ready scenes as OBJ files: make_meshes FOLDER
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using std::numbers::pi;

struct Vec {
  double x = 0, y = 0, z = 0;
};

Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
Vec operator-(Vec a, Vec b) { return a + -1.0 * b; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec unit(Vec a) { return 1.0 / std::sqrt(dot(a, a)) * a; }

/// A point of a surface with its outward unit normal.
struct Vertex {
  Vec position, normal;
};

/// Nine significant digits identify a float uniquely, and hide the last bits of the maths library.
std::string digits(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value + 0.0,
                                 std::chars_format::general, 9);
  return {text.data(), end.ptr};
}

std::string triple(const char* keyword, Vec v) {
  return std::string(keyword) + " " + digits(v.x) + " " + digits(v.y) + " " + digits(v.z) + "\n";
}

/// Quads (four corners each, counter-clockwise from outside) without normals.
std::string flatQuads(const std::vector<std::array<Vec, 4>>& quads) {
  std::string vertices, faces;
  std::size_t next = 1;
  for (const std::array<Vec, 4>& quad : quads) {
    faces += "f";
    for (const Vec corner : quad) {
      vertices += triple("v", corner);
      faces += " " + std::to_string(next++);
    }
    faces += "\n";
  }
  return vertices + faces;
}

/// The quad with this centre, spanned by u and v; it faces u x v.
std::array<Vec, 4> quad(Vec centre, Vec u, Vec v) {
  return {centre - u - v, centre + u - v, centre + u + v, centre - u + v};
}

/// A surface closed in both directions over (s, t) in [0, 1)^2, as rows x columns quads with
/// normals and texture coordinates. d/ds x d/dt points outwards.
std::string closedSurface(int rows, int columns,
                          const std::function<Vertex(double s, double t)>& at) {
  std::string positions, normals, uvs, faces;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const Vertex vertex = at(static_cast<double>(i) / rows, static_cast<double>(j) / columns);
      positions += triple("v", vertex.position);
      normals += triple("vn", vertex.normal);
    }
  }
  for (int i = 0; i <= rows; ++i) {
    for (int j = 0; j <= columns; ++j) {
      uvs += "vt " + digits(static_cast<double>(i) / rows) + " " +
             digits(static_cast<double>(j) / columns) + "\n";
    }
  }
  const auto corner = [&](int i, int j) {
    const std::string vertex = std::to_string(i % rows * columns + j % columns + 1);
    return " " + vertex + "/" + std::to_string(i * (columns + 1) + j + 1) + "/" + vertex;
  };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      faces +=
          "f" + corner(i, j) + corner(i + 1, j) + corner(i + 1, j + 1) + corner(i, j + 1) + "\n";
    }
  }
  return positions + uvs + normals + faces;
}

/// A sphere-like surface of triangles by latitude and longitude, with one vertex at each pole
/// (+-y).
std::string closedSphere(int rings, int columns, const std::function<Vertex(Vec direction)>& at) {
  std::string positions, normals, faces;
  const auto put = [&](Vec direction) {
    const Vertex vertex = at(direction);
    positions += triple("v", vertex.position);
    normals += triple("vn", vertex.normal);
  };
  const auto face = [&](int a, int b, int c) {
    faces += "f";
    for (const int i : {a, b, c}) faces += " " + std::to_string(i) + "//" + std::to_string(i);
    faces += "\n";
  };
  put({0, 1, 0});
  for (int i = 1; i < rings; ++i) {
    for (int j = 0; j < columns; ++j) {
      const double theta = pi * i / rings, phi = 2 * pi * j / columns;
      put({std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)});
    }
  }
  put({0, -1, 0});
  const auto index = [&](int i, int j) { return 2 + (i - 1) * columns + j % columns; };
  const int south = 2 + (rings - 1) * columns;
  for (int j = 0; j < columns; ++j) {
    face(1, index(1, j), index(1, j + 1));
    for (int i = 1; i + 1 < rings; ++i) {
      face(index(i, j), index(i + 1, j), index(i + 1, j + 1));
      face(index(i, j), index(i + 1, j + 1), index(i, j + 1));
    }
    face(index(rings - 1, j), south, index(rings - 1, j + 1));
  }
  return positions + normals + faces;
}

/// A torus with axis y and radii 1 and 0.4.
Vertex torus(double s, double t) {
  const double a = 2 * pi * t, b = 2 * pi * s;
  const Vec out{std::sin(a), 0, std::cos(a)};
  const Vec normal = std::cos(b) * out + std::sin(b) * Vec{0, -1, 0};
  return {out + 0.4 * normal, normal};
}

/// A sphere of radius r(d) = 1 + a g(d), with g(d) = sin(k x) sin(k y) sin(k z) of the unit
/// direction d. Its normal is parallel to d - a (grad g - (grad g . d) d) / r.
Vertex wavySphere(Vec d) {
  constexpr double a = 0.35, k = 4.0;
  const Vec s{std::sin(k * d.x), std::sin(k * d.y), std::sin(k * d.z)};
  const Vec c{std::cos(k * d.x), std::cos(k * d.y), std::cos(k * d.z)};
  const Vec gradient = k * Vec{c.x * s.y * s.z, s.x * c.y * s.z, s.x * s.y * c.z};
  const double r = 1 + a * s.x * s.y * s.z;
  return {r * d, unit(d - a / r * (gradient - dot(gradient, d) * d))};
}

/// A tube of radius 0.2 around c(u) = (sin u + 2 sin 2u, cos u - 2 cos 2u, -sin 3u) / 3, in its
/// Frenet frame. The knot differs from its mirror image.
Vertex trefoil(double s, double t) {
  const double u = 2 * pi * s, b = 2 * pi * t;
  const Vec centre =
      1.0 / 3 *
      Vec{std::sin(u) + 2 * std::sin(2 * u), std::cos(u) - 2 * std::cos(2 * u), -std::sin(3 * u)};
  const Vec tangent = unit({std::cos(u) + 4 * std::cos(2 * u), -std::sin(u) + 4 * std::sin(2 * u),
                            -3 * std::cos(3 * u)});
  const Vec second{-std::sin(u) - 8 * std::sin(2 * u), -std::cos(u) + 8 * std::cos(2 * u),
                   9 * std::sin(3 * u)};
  const Vec inward = unit(second - dot(second, tangent) * tangent);
  const Vec normal = std::cos(b) * inward + std::sin(b) * cross(inward, tangent);
  return {centre + 0.2 * normal, normal};
}

/// Writes a temporary file and renames it, so that a reader never sees half of it.
void save(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path temporary = file.string() + ".tmp";
  std::ofstream stream(temporary, std::ios::binary);
  stream << "# Made by make_meshes.cpp.\n" << text;
  stream.close();
  if (!stream) throw std::runtime_error("cannot write " + temporary.string());
  std::filesystem::rename(temporary, file);
}

void makeMeshes(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const Vec x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const Vec right = -1.0 * x, down = -1.0 * y, back = -1.0 * z;
  save(folder / "plane.obj", flatQuads({quad({}, z, x)}));
  // The plane with texture coordinates: u along x, v away from +z.
  save(folder / "sheet.obj",
       "v -1 0 1\nv 1 0 1\nv 1 0 -1\nv -1 0 -1\n"
       "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n");
  save(folder / "block.obj", flatQuads({quad(x, y, z), quad(y, z, x), quad(z, x, y),
                                        quad(right, z, y), quad(down, x, z), quad(back, y, x)}));
  // The inside of the cube [-1, 1]^3, open towards +z.
  save(folder / "room.obj", flatQuads({quad(down, z, x), quad(y, x, z), quad(back, x, y)}));
  save(folder / "room-left.obj", flatQuads({quad(right, y, z)}));
  save(folder / "room-right.obj", flatQuads({quad(x, z, y)}));
  save(folder / "torus.obj", closedSurface(16, 36, torus));
  save(folder / "wavy-sphere.obj", closedSphere(48, 96, wavySphere));
  save(folder / "trefoil.obj", closedSurface(240, 16, trefoil));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_meshes FOLDER\n", stderr);
    return 2;
  }
  try {
    makeMeshes(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_meshes: %s\n", error.what());
    return 1;
  }
  return 0;
}
