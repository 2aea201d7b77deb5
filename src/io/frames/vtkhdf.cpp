#include "io/frames/vtkhdf.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

#include "base/contract.hpp"
#include "io/frames/chunks.hpp"
#include "io/frames/vtkhdf_session.hpp"
#include "io/hdf5/staged.hpp"
#include "io/output/file.hpp"

namespace perimpact::frames {

namespace {

using output::PolyData;

constexpr const char* cell_kinds[] = {"Vertices", "Lines", "Polygons", "Strips"};  // in the order of the columns of CellOffsets
constexpr hsize_t step_chunk = 128;                                                // entries of a chunk of the arrays with one entry per step
constexpr std::size_t varying_rows = 8192;                                         // of a chunk of the arrays whose length differs between steps

constexpr hsize_t whole_chunks(std::size_t count, std::size_t rows) { return (count + rows - 1) / rows * rows; }

/// An array of a frame, with its place in the file.
struct Place {
  std::string name, offsets;  ///< below VTKHDF: "PointData/damage", "Steps/PointDataOffsets/damage"
  int components;
  const output::Numbers& numbers;
  bool is_constant;

  std::size_t rows() const { return output::count_of(numbers) / static_cast<std::size_t>(components); }
};

std::vector<Place> places_of(const PolyData& frame) {
  std::vector<Place> places = {{"Points", "Steps/PointOffsets", 3, frame.points, false}};
  const auto add = [&](const std::string& group, const std::vector<output::VtpArray>& arrays) {
    for (const output::VtpArray& each : arrays)
      places.push_back({group + "/" + each.name, "Steps/" + group + "Offsets/" + each.name, each.components, each.numbers, each.is_constant});
  };
  add("PointData", frame.point_arrays), add("CellData", frame.cell_arrays);
  return places;
}

hid_t type_of(const output::Numbers& numbers) {
  return std::visit(
      []<class Given>(const Given&) {
        if constexpr (std::is_same_v<Given, output::MadeFloats>)
          return hdf5::type_in_memory(hdf5::NumberType::float32);
        else
          return hdf5::type_in_memory(hdf5::number_type<typename Given::value_type>());
      },
      numbers);
}

/// Row behind the chunks of the steps before this one, in an array of one row per point that varies.
hsize_t end_before(const Session& session, const std::string& offsets, hsize_t step) {
  if (step == 0) return 0;
  return static_cast<hsize_t>(entry(session, offsets, step - 1)) +
         whole_chunks(static_cast<std::size_t>(entry(session, "NumberOfPoints", step - 1)), varying_rows);
}

/// Appends the rows of a step as whole chunks.
void append(const Session& session, const Place& place, hsize_t step, bool varies) {
  if (place.is_constant && step > 0) return set_entry(session, place.offsets, step, std::int64_t{0});
  const std::size_t rows = varies ? varying_rows : rows_of_chunk(place.rows());
  const hsize_t first = varies ? end_before(session, place.offsets, step) : step * whole_chunks(place.rows(), rows);
  const auto write = [&]<class Number>(std::span<const Number> numbers) {
    append_rows(session, place.name, first, rows, std::as_bytes(numbers), sizeof(Number) * static_cast<std::size_t>(place.components), sizeof(Number));
  };
  std::visit(
      [&]<class Given>(const Given& given) {
        if constexpr (std::is_same_v<Given, output::MadeFloats>)
          write(std::span<const float>(given.make()));
        else
          write(given);
      },
      place.numbers);
  set_entry(session, place.offsets, step, static_cast<std::int64_t>(first));
}

/// Row in Vertices/Offsets behind the chunks of the steps before this one, each of which has one entry more than it has vertices.
hsize_t ends_before(const Session& session, hsize_t step) {
  if (step == 0) return 0;
  const hsize_t first = static_cast<hsize_t>(entry(session, "Steps/CellOffsets", step - 1)) + step - 1;
  return first + whole_chunks(static_cast<std::size_t>(entry(session, "NumberOfPoints", step - 1)) + 1, varying_rows);
}

/// Appends the cells of a step with its own number of particles as a part of its own. CellOffsets count cells; the Offsets of a part begin one row further on
/// for each part before it.
void append_vertices(const Session& session, std::size_t points, hsize_t step) {
  std::int64_t cells[std::size(cell_kinds)] = {}, ids[std::size(cell_kinds)] = {};
  const hsize_t ends = ends_before(session, step), corners = end_before(session, "Steps/ConnectivityIdOffsets", step);
  cells[0] = static_cast<std::int64_t>(ends - step), ids[0] = static_cast<std::int64_t>(corners);
  std::vector<std::int64_t> numbers(points + 1);
  std::iota(numbers.begin(), numbers.end(), 0);
  const auto write = [&](const std::string& name, hsize_t first, std::size_t count) {
    append_rows(session, name, first, varying_rows, std::as_bytes(std::span(numbers).first(count)), sizeof(std::int64_t), sizeof(std::int64_t));
  };
  write("Vertices/Offsets", ends, points + 1), write("Vertices/Connectivity", corners, points);
  for (const std::string kind : cell_kinds) {
    const std::int64_t count = kind == cell_kinds[0] ? static_cast<std::int64_t>(points) : 0;
    set_entry(session, kind + "/NumberOfCells", step, count), set_entry(session, kind + "/NumberOfConnectivityIds", step, count);
    if (kind != cell_kinds[0]) set_entry(session, kind + "/Offsets", step, std::int64_t{0});
  }
  set_entry(session, "NumberOfPoints", step, static_cast<std::int64_t>(points));
  set_entry(session, "Steps/CellOffsets", step, std::span<const std::int64_t>(cells));
  set_entry(session, "Steps/ConnectivityIdOffsets", step, std::span<const std::int64_t>(ids));
}

/// NSteps and Steps/Values, by which readers find the step, are the last that they see (StagedStorage).
void add_step(const Session& session, const PolyData& frame, double time, std::int64_t step) {
  const auto number = static_cast<hsize_t>(step);
  for (const Place& place : places_of(frame)) append(session, place, number, frame.varies);
  set_entry(session, "Steps/PartOffsets", number, frame.varies ? step : 0);
  set_entry(session, "Steps/NumberOfParts", number, std::int64_t{1});
  if (frame.varies) {
    append_vertices(session, output::count_of(frame.points) / 3, number);
  } else {
    constexpr std::int64_t none[std::size(cell_kinds)] = {};
    set_entry(session, "Steps/CellOffsets", number, std::span<const std::int64_t>(none));
    set_entry(session, "Steps/ConnectivityIdOffsets", number, std::span<const std::int64_t>(none));
  }
  set_entry(session, "Steps/Values", number, std::span<const double>(&time, 1));
  set_steps(session, step + 1);
}

/// The cells of a frame: one vertex per particle, or the panels.
void write_cells(const Session& session, const PolyData& frame) {
  const std::int64_t points = static_cast<std::int64_t>(output::count_of(frame.points) / 3);
  std::vector<std::int64_t> connectivity, offsets{0};
  if (frame.panels.empty()) {
    connectivity.resize(static_cast<std::size_t>(points)), offsets.resize(static_cast<std::size_t>(points) + 1);
    std::iota(connectivity.begin(), connectivity.end(), 0), std::iota(offsets.begin(), offsets.end(), 0);
  }
  for (const std::array<int, 4>& panel : frame.panels) {
    connectivity.insert(connectivity.end(), panel.begin(), panel[3] < 0 ? panel.end() - 1 : panel.end());
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  write_fixed(session, "NumberOfPoints", std::span<const std::int64_t>(&points, 1));
  const std::string_view kind = frame.panels.empty() ? "Vertices" : "Polygons";
  for (const std::string group : cell_kinds) {
    make_group(session, "VTKHDF/" + group);
    const bool has_cells = group == kind;
    const std::int64_t cells = has_cells ? static_cast<std::int64_t>(offsets.size()) - 1 : 0,
                       ids = has_cells ? static_cast<std::int64_t>(connectivity.size()) : 0;
    write_fixed(session, group + "/NumberOfCells", std::span<const std::int64_t>(&cells, 1));
    write_fixed(session, group + "/NumberOfConnectivityIds", std::span<const std::int64_t>(&ids, 1));
    write_fixed(session, group + "/Offsets", std::span<const std::int64_t>(offsets).first(static_cast<std::size_t>(cells) + 1));
    write_fixed(session, group + "/Connectivity", std::span<const std::int64_t>(connectivity).first(static_cast<std::size_t>(ids)));
  }
}

/// Empty arrays for the cells of frames each of which has its own number of particles. The groups come first: what changes with a step must not lie across the
/// end of the first page, which is written on its own.
void make_varying_cells(const Session& session) {
  const auto make = [&](const std::string& name, hsize_t rows, bool is_packed) {
    make_dataset(session, name, H5T_NATIVE_INT64, {0, 1, rows, true, is_packed});
  };
  for (const std::string kind : cell_kinds) make_group(session, "VTKHDF/" + kind);
  make("NumberOfPoints", step_chunk, false);
  for (const std::string kind : cell_kinds) {
    const bool has_cells = kind == cell_kinds[0];
    make(kind + "/NumberOfCells", step_chunk, false), make(kind + "/NumberOfConnectivityIds", step_chunk, false);
    make(kind + "/Offsets", has_cells ? varying_rows : step_chunk, has_cells), make(kind + "/Connectivity", has_cells ? varying_rows : step_chunk, has_cells);
  }
}

/// Groups, the arrays of steps and empty arrays of the frames. The first page contains the headers of Steps and Steps/Values, so they come first.
void make_structure(const Session& session, const PolyData& frame) {
  make_group(session, "VTKHDF"), make_group(session, "VTKHDF/Steps");
  const Handle one(H5Screate(H5S_SCALAR), H5Sclose);
  const std::int64_t none = 0, version[] = {2, 0};
  put_attribute(session, "VTKHDF/Steps", "NSteps", H5T_NATIVE_INT64, one, &none);
  make_dataset(session, "Steps/Values", H5T_NATIVE_DOUBLE, {0, 1, step_chunk, true, false});

  const hsize_t two = 2;
  put_attribute(session, "VTKHDF", "Version", H5T_NATIVE_INT64, Handle(H5Screate_simple(1, &two, nullptr), H5Sclose), version);
  constexpr std::string_view type = "PolyData";
  const Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(text.id(), type.size()), H5Tset_strpad(text.id(), H5T_STR_NULLPAD);  // VTK takes its whole length as the word
  put_attribute(session, "VTKHDF", "Type", text.id(), one, type.data());
  frame.varies ? make_varying_cells(session) : write_cells(session, frame);

  const auto per_step = [&](const std::string& name, hsize_t columns) { make_dataset(session, name, H5T_NATIVE_INT64, {0, columns, step_chunk, true, false}); };
  per_step("Steps/PartOffsets", 1), per_step("Steps/NumberOfParts", 1);
  per_step("Steps/CellOffsets", std::size(cell_kinds)), per_step("Steps/ConnectivityIdOffsets", std::size(cell_kinds));
  for (const std::string group : {"PointData", "CellData"})
    if (!(group == "PointData" ? frame.point_arrays : frame.cell_arrays).empty())
      make_group(session, "VTKHDF/" + group), make_group(session, "VTKHDF/Steps/" + group + "Offsets");
  for (const Place& place : places_of(frame)) {
    make_dataset(session, place.name, type_of(place.numbers),
                 {0, static_cast<hsize_t>(place.components), frame.varies ? varying_rows : rows_of_chunk(place.rows()), true, true});
    per_step(place.offsets, 1);
  }
}

/// Runs a session on a file that readers may open at any moment.
template <class Change>
void change(hdf5::Storage& storage, const std::string& file, const Change& work) {
  hdf5::StagedStorage staged(storage);
  try {
    Session session(staged, file);
    session.open();
    work(session);
    session.close();
  } catch (...) {
    staged.discard();
    throw;
  }
  staged.commit();
}

/// Cuts an array of the frames and its offsets to their first steps, of which each or all have that many rows.
void truncate(const Session& session, const std::string& name, const std::string& offsets, hsize_t steps, hsize_t rows) {
  const Handle dataset = session.dataset(name);
  set_length(session, dataset, std::min<hsize_t>(extent_of(session, dataset)[0], rows));  // a constant array is shorter
  set_length(session, session.dataset(offsets), steps);
}

template <class Rows>
void truncate_all(const Session& session, const std::string& group, hsize_t steps, const Rows& rows) {
  for (const std::string& name : names_in(session, group)) {
    const std::string offsets = "Steps/" + group + "Offsets/" + name;
    truncate(session, group + "/" + name, offsets, steps, rows(offsets));
  }
}

/// Where all steps have the same points and cells.
void truncate_equal_steps(const Session& session, hsize_t steps) {
  const auto rows_of = [steps](std::int64_t count) {
    return [=](const std::string&) { return steps * whole_chunks(static_cast<std::size_t>(count), rows_of_chunk(static_cast<std::size_t>(count))); };
  };
  const auto points = rows_of(fixed_number(session, "NumberOfPoints"));
  std::int64_t cells = 0;
  for (const std::string kind : cell_kinds) cells += fixed_number(session, kind + "/NumberOfCells");
  truncate(session, "Points", "Steps/PointOffsets", steps, points("Steps/PointOffsets"));
  truncate_all(session, "PointData", steps, points), truncate_all(session, "CellData", steps, rows_of(cells));
}

void truncate_varying_steps(const Session& session, hsize_t steps) {
  const auto rows = [&](const std::string& offsets) { return end_before(session, offsets, steps); };
  truncate(session, "Points", "Steps/PointOffsets", steps, rows("Steps/PointOffsets"));
  truncate_all(session, "PointData", steps, rows);
  set_length(session, session.dataset("Vertices/Offsets"), ends_before(session, steps));
  set_length(session, session.dataset("Vertices/Connectivity"), rows("Steps/ConnectivityIdOffsets"));
  set_length(session, session.dataset("NumberOfPoints"), steps);
  for (const std::string kind : cell_kinds) {
    for (const char* count : {"/NumberOfCells", "/NumberOfConnectivityIds"}) set_length(session, session.dataset(kind + count), steps);
    if (kind != cell_kinds[0]) set_length(session, session.dataset(kind + "/Offsets"), steps);
  }
}

/// Cuts the arrays of the frames to their first steps.
void truncate_arrays(const Session& session, hsize_t steps) {
  grows(session, session.dataset("NumberOfPoints")) ? truncate_varying_steps(session, steps) : truncate_equal_steps(session, steps);
  for (const char* name : {"PartOffsets", "NumberOfParts", "CellOffsets", "ConnectivityIdOffsets"})
    set_length(session, session.dataset(std::string("Steps/") + name), steps);
}

}  // namespace

void create_vtkhdf(hdf5::Storage& storage, const std::string& file, const PolyData& frame, double time) {
  Session session(storage, file);
  const Handle root = creation(H5P_FILE_CREATE);
  session.opened = Handle(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, root.id(), session.access.id()), H5Fclose);
  session.expect(session.opened.is_open());
  make_structure(session, frame);
  add_step(session, frame, time, 0);
  session.close();
}

void append_vtkhdf(hdf5::Storage& storage, const std::string& file, const PolyData& frame, double time) {
  change(storage, file, [&](const Session& session) { add_step(session, frame, time, steps_in(session)); });
}

void truncate_vtkhdf(hdf5::Storage& storage, const std::string& file, std::size_t steps) {
  EXPECTS(steps > 0);
  change(storage, file, [&](const Session& session) {  // first, so that readers look for no step that disappears
    set_steps(session, static_cast<std::int64_t>(steps));
    set_length(session, session.dataset("Steps/Values"), steps);
  });
  change(storage, file, [&](const Session& session) { truncate_arrays(session, steps); });
}

VtkhdfSeries::VtkhdfSeries(std::filesystem::path file, std::vector<double> times) : file_(std::move(file)), times_(std::move(times)) {
  std::error_code none;
  if (times_.empty()) {
    std::filesystem::remove(file_, none);
    return;
  }
  output::UpdatedFile updated(file_);
  hdf5::FileStorage storage(updated);
  truncate_vtkhdf(storage, file_.string(), times_.size());
}

void VtkhdfSeries::add(const PolyData& frame, double time) {
  if (times_.empty()) {
    output::WholeFile whole(file_);
    hdf5::FileStorage storage(whole);
    create_vtkhdf(storage, file_.string(), frame, time);
    whole.finish();
  } else {
    output::UpdatedFile updated(file_);
    hdf5::FileStorage storage(updated);
    append_vtkhdf(storage, file_.string(), frame, time);
  }
  times_.push_back(time);
}

void VtkhdfSeries::sync() const {
  if (!times_.empty()) output::UpdatedFile(file_).sync();
}

}  // namespace perimpact::frames
