#include "physics/goods/hull_meshes.h"

#include <mujoco/mjxmacro.h>

#include <algorithm>

namespace marketgen::physics {
namespace {

// mjXMACRO's tables that are as long as the number of meshes, vertices, faces and so on. XNV are
// those that MuJoCo's own copies for other devices leave out.
#define MARKETGEN_MESH_TABLES \
  MJMODEL_POINTERS_MESH       \
  X(int, name_meshadr, nmesh, 1)

constexpr int names_a_mesh = 2;      // entries of names_map, MuJoCo's mjLOAD_MULTIPLE
constexpr mjtSize table_bytes = 64;  // each table begins at a multiple of this

// Bytes of the model's buffer, as mj_makeModel counts them.
mjtSize buffer_bytes(const mjModel* m) {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"  // MuJoCo's macro makes its sizes ints
  MJMODEL_POINTERS_PREAMBLE(m)
#pragma GCC diagnostic pop
  mjtSize bytes = 0;
#define X(type, name, rows, columns)                              \
  bytes = (bytes + table_bytes - 1) / table_bytes * table_bytes + \
          static_cast<mjtSize>(sizeof(type)) * (m->rows) * (columns);
#define XNV X
  MJMODEL_POINTERS
#undef XNV
#undef X
  return bytes;
}

template <class T>
void append(std::vector<std::byte>& kept, T*& table, mjtSize rows, const T* more, mjtSize count) {
  const auto* const now = reinterpret_cast<const std::byte*>(table);
  const auto* const add = reinterpret_cast<const std::byte*>(more);
  if (kept.empty()) kept.assign(now, now + static_cast<std::size_t>(rows) * sizeof(T));
  kept.insert(kept.end(), add, add + static_cast<std::size_t>(count) * sizeof(T));
  if (!kept.empty()) table = reinterpret_cast<T*>(kept.data());  // mj_saveModel takes no null
}

// Makes room for names of meshes among those of all things, which are found by their places.
void add_names(std::vector<std::byte>& kept, mjModel& m, mjtSize meshes) {
  const mjtSize before =
      names_a_mesh * (m.nbody + m.njnt + m.ngeom + m.nsite + m.ncam + m.nlight + m.nflex + m.nmesh);
  const std::vector<int> none(static_cast<std::size_t>(names_a_mesh * meshes), -1);
  append(kept, m.names_map, m.nnames_map, none.data(), names_a_mesh * meshes);
  m.nnames_map += names_a_mesh * meshes;
  std::rotate(m.names_map + before,
              m.names_map + m.nnames_map - names_a_mesh * meshes,
              m.names_map + m.nnames_map);
}

// What in a table is a place in another one of all meshes.
template <class T>
void shift(T* table, mjtSize from, mjtSize to, mjtSize by) {
  for (mjtSize i = from; i < to; ++i)
    table[i] += static_cast<T>(by);
}

}  // namespace

int HullMeshes::add(const mjModel& from) {
  mjModel& m = model_;
  const mjModel was = m;  // its sizes
  const mjtSize bytes = buffer_bytes(&m);
  add_names(kept_.back(), m, from.nmesh);
  std::size_t table = 0;
#define X(type, name, rows, columns) \
  append(kept_.at(table++), m.name, m.rows*(columns), from.name, from.rows*(columns));
#define XNV X
  MARKETGEN_MESH_TABLES
#undef XNV
#undef X
  m.nmesh += from.nmesh;
  m.nmeshvert += from.nmeshvert;
  m.nmeshnormal += from.nmeshnormal;
  m.nmeshtexcoord += from.nmeshtexcoord;
  m.nmeshface += from.nmeshface;
  m.nmeshgraph += from.nmeshgraph;
  m.nmeshpoly += from.nmeshpoly;
  m.nmeshpolyvert += from.nmeshpolyvert;
  m.nmeshpolymap += from.nmeshpolymap;
  m.npolygonmax = std::max(m.npolygonmax, from.npolygonmax);
  m.nmeshdegmax = std::max(m.nmeshdegmax, from.nmeshdegmax);
  shift(m.mesh_vertadr, was.nmesh, m.nmesh, was.nmeshvert);
  shift(m.mesh_faceadr, was.nmesh, m.nmesh, was.nmeshface);
  shift(m.mesh_normaladr, was.nmesh, m.nmesh, was.nmeshnormal);
  shift(m.mesh_graphadr, was.nmesh, m.nmesh, was.nmeshgraph);
  shift(m.mesh_polyadr, was.nmesh, m.nmesh, was.nmeshpoly);
  shift(m.mesh_polyvertadr, was.nmeshpoly, m.nmeshpoly, was.nmeshpolyvert);
  shift(m.mesh_polymapadr, was.nmeshvert, m.nmeshvert, was.nmeshpolymap);
  const auto nameless = static_cast<int>(std::find(m.names, m.names + m.nnames, '\0') - m.names);
  for (mjtSize mesh = was.nmesh; mesh < m.nmesh; ++mesh) {
    m.mesh_bvhadr[mesh] = -1, m.mesh_bvhnum[mesh] = 0;
    m.name_meshadr[mesh] = nameless;
  }
  m.nbuffer += buffer_bytes(&m) - bytes;
  return static_cast<int>(was.nmesh);
}

}  // namespace marketgen::physics
