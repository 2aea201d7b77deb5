#include "io/checkpoint/checkpoint.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <functional>

#include "base/error.hpp"
#include "fixtures/temporary_folder.hpp"
#include "io/checkpoint/arrays_writer.hpp"
#include "io/checkpoint/checkpoints.hpp"
#include "io/deck/deck.hpp"
#include "perimpact/deck_model/setup_error.hpp"

using namespace perimpact;

namespace {

const std::string small = R"(
title: Small plate
time: {end: 20 us, step: 1 us}
bodies:
  plate:
    shape: {box: {size: [40 mm, 40 mm, 20 mm]}}
    spacing: 5 mm
    material: {model: ordinary-state, youngs_modulus: 191 GPa, poissons_ratio: 0.25, density: 8000, critical_stretch: 1e-3}
impactors:
  block:
    surface: {file: block.obj}
    mass: 1
    position: [0, 36 mm, 0]
    velocity: [0, -200, 0]
    free_dofs: [y]
output: {frames: 3, history_interval: 2 us, checkpoint_interval: 0}
)";

/// A box of 2 · 16 mm in y and the given half-width in x; oriented outward.
std::string block(double half_width) {
  std::string text;
  for (const double x : {-half_width, half_width})
    for (const double y : {-0.016, 0.016})
      for (const double z : {-0.02, 0.02}) text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  return text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";
}

struct Scene {
  fixtures::TemporaryFolder folder;
  std::filesystem::path results = folder / "r", file = folder / "r/checkpoint.h5";

  Scene() { fixtures::put(folder / "block.obj", block(0.02)); }
  Setup setup(const std::vector<std::string>& changes = {}) const { return deck::read_deck_text(small, "deck.yaml", folder.path(), changes).setup; }

  long last_step() const { return newest_checkpoint(results).step; }

  /// Runs up to a step and writes a checkpoint.
  void run_to(long step) const {
    Simulation simulation(setup());
    Checkpoints checkpoints(results, simulation);
    ResultsWriter writer(simulation, results);
    while (simulation.clock().step < step) simulation.step(), writer.after_step(simulation);
    checkpoints.write(simulation, writer);
  }

  /// The message and key of a refused restart.
  std::string complaint(const Setup& wanted, std::string* key = nullptr) const {
    try {
      Checkpoint checkpoint(file);
      checkpoint.expect_deck(wanted);
      Simulation simulation(wanted);
      const Written written = checkpoint.restore(simulation, fingerprint_at_start(simulation));
      ResultsWriter writer(simulation, results, written);
    } catch (const SetupError& error) {
      if (key) *key = error.key();
      return error.what();
    } catch (const fccda::InputError& error) {
      return error.what();
    }
    return "";
  }
};

void append(const std::filesystem::path& path, const std::string& text) { std::ofstream(path, std::ios::app) << text; }

}  // namespace

TEST_CASE("checkpoint: a restarted simulation reaches the same state bitwise, with the same result files") {
  Scene whole, parted;
  whole.run_to(20);
  parted.run_to(9);
  // output after the checkpoint, before the run was killed
  append(parted.results / "history.csv", "1,2,3\n4,5");
  append(parted.results / "pressure_area/block.csv", "6,7");
  append(parted.results / "fragments/plate.csv", "8,9\n");
  fixtures::put(parted.results / "frames/plate_00002.vtp", "later");
  fixtures::put(parted.results / "frames/block_00004.vtp.part", "in part");
  fixtures::put(parted.results / "run.json", "of a run that was interrupted");

  Checkpoint checkpoint(parted.file);
  CHECK(checkpoint.step() == 9);
  CHECK(checkpoint.steps() == 20);
  checkpoint.expect_deck(parted.setup());
  Simulation simulation(parted.setup());
  Checkpoints checkpoints(parted.results, simulation);
  ResultsWriter writer(simulation, parted.results, checkpoints.resume(simulation));
  CHECK(checkpoints.last() == 9);
  CHECK(writer.resumed_at() == std::vector<std::int64_t>{9});
  CHECK(simulation.clock().step == 9);
  CHECK(!std::filesystem::exists(parted.results / "frames/plate_00002.vtp"));
  while (!simulation.clock().is_finished()) simulation.step(), writer.after_step(simulation);
  checkpoints.write(simulation, writer);
  CHECK(parted.last_step() == 20);

  Simulation other(whole.setup());
  while (!other.clock().is_finished()) other.step();
  CHECK(simulation.state_hash() == other.state_hash());
  CHECK(simulation.bodies()[0].internal.broken_bonds() > 0);
  std::set<std::string> names = fixtures::files_in(whole.results);
  for (const char* table : {"pressure_area/block.csv", "fragments/plate.csv"}) CHECK(names.count(table) == 1);
  CHECK(fixtures::files_in(parted.results) == names);
  names.erase("checkpoint.h5");  // it contains the steps of restarts and counters of detection
  for (const std::string& name : names) CHECK_MESSAGE(fixtures::text_of(parted.results / name) == fixtures::text_of(whole.results / name), name);
}

TEST_CASE("checkpoint: a missing one is reported") {
  const Scene scene;
  CHECK(scene.complaint(scene.setup()) == "there is no checkpoint " + scene.file.string() + ", so there is nothing to resume; run without --resume.");
}

TEST_CASE("checkpoint: a checkpoint of another version is refused") {
  const Scene scene;
  std::filesystem::create_directories(scene.results);
  checkpoint::ArraysWriter file(scene.file);
  file.word("program", "perimpact 0.0.1");
  file.finish();
  CHECK(scene.complaint(scene.setup()) == scene.file.string() +
                                              " was written by perimpact 0.0.1, but this is perimpact " PERIMPACT_VERSION
                                              ", whose results may differ; resume with the original version, or start a new run without --resume.");
}

TEST_CASE("checkpoint: a checkpoint of another deck is refused with the first differing key and both values, but folder and interval may differ") {
  const Scene scene;
  scene.run_to(3);
  std::string key;
  CHECK(scene.complaint(scene.setup({"impactors.block.mass=2", "output.frames=4"}), &key) ==
        "impactors.block.mass is 2 here, but 1 in the run of the checkpoint " + scene.file.string() +
            "; resume with the same deck, or start a new run without --resume.");
  CHECK(key == "impactors.block.mass");
  CHECK(scene.complaint(scene.setup({"bodies.plate.horizon_ratio=4"}), &key).find("is 4 here, but 3.015 in the run") != std::string::npos);
  CHECK(scene.complaint(scene.setup({"output.probes.tip={body: plate, at: [0, 0, 0]}"}), &key).find("but not given in the run") != std::string::npos);
  CHECK(key == "output.probes.tip");
  CHECK(scene.complaint(scene.setup({"output.folder=elsewhere", "output.checkpoint_interval=7 s", "output.checkpoints_kept=3"})).empty());
}

TEST_CASE("checkpoint: a changed surface file is detected, and a moved one is accepted") {
  const Scene scene;
  scene.run_to(3);
  fixtures::put(scene.folder / "block.obj", block(0.0201));  // as many panels, the same mass, motion and distance
  CHECK(scene.complaint(scene.setup()).find("a file that the deck refers to has changed") != std::string::npos);
  fixtures::put(scene.folder / "moved/block.obj", block(0.02));
  CHECK(scene.complaint(scene.setup({"impactors.block.surface.file=moved/block.obj"})).empty());
}

TEST_CASE("checkpoint: a changed file is detected even without effect on the initial state") {
  const Scene scene;
  scene.run_to(3);
  append(scene.folder / "block.obj", "# a comment\n");  // stands for contact bounds that are not yet in use
  CHECK(scene.complaint(scene.setup()).find("a file that the deck refers to has changed") != std::string::npos);
}

TEST_CASE("checkpoint: shortened tables are refused before anything is changed") {
  for (const char* name : {"history.csv", "pressure_area/block.csv", "fragments/plate.csv"}) {
    const Scene scene;
    scene.run_to(9);
    const auto table = scene.results / name;
    const std::string text = fixtures::text_of(table);
    append(scene.results / "history.csv", "later");
    fixtures::put(table, text.substr(0, text.size() - 1));
    const std::string history = fixtures::text_of(scene.results / "history.csv");
    CHECK(scene.complaint(scene.setup()) ==
          table.string() + " is shorter than when the checkpoint was written, so the run cannot be resumed; restore it, or replace the run by a new one.");
    CHECK(fixtures::text_of(scene.results / "history.csv") == history);
    std::filesystem::remove(table);
    CHECK(scene.complaint(scene.setup()).find("is missing, so the run cannot be resumed") != std::string::npos);
  }
}

TEST_CASE("checkpoint: one is written after each interval, and with interval 0 only on request") {
  const Scene scene;
  for (const char* every : {"0", "1 h", "1e-9 s"}) {
    Simulation simulation(scene.setup({std::string("output.checkpoint_interval=") + every}));
    Checkpoints checkpoints(scene.results, simulation);
    ResultsWriter writer(simulation, scene.results);
    simulation.step();
    checkpoints.after_step(simulation, writer);
    CHECK(checkpoints.last().has_value() == (std::string(every) == "1e-9 s"));
    checkpoints.write(simulation, writer);
    CHECK(Checkpoint(scene.file).step() == 1);
  }
}
