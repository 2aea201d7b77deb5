/// The same file read by assimp: CSV rows on standard output. read: no post-processing; read and join: with identical vertices merged.

#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "timed_rounds.hpp"

int main(int argc, char** argv) {
  std::string file;
  int rounds = 3;
  bool join = false;
  CLI::App app("Times reading of a surface file by assimp; prints CSV rows.");
  app.add_option("file", file)->required()->check(CLI::ExistingFile);
  app.add_option("--rounds", rounds)->check(CLI::PositiveNumber);
  app.add_flag("--join", join);
  CLI11_PARSE(app, argc, argv);

  benchmark::TimedRounds timed;
  for (int round = 0; round < rounds; ++round) {
    const aiScene* scene = timed(join ? "read and join" : "read", [&] { return aiImportFile(file.c_str(), join ? aiProcess_JoinIdenticalVertices : 0u); });
    if (scene == nullptr) {
      std::fprintf(stderr, "error: assimp cannot read %s: %s\n", file.c_str(), aiGetErrorString());
      return 2;
    }
    aiReleaseImport(scene);
  }
  timed.print();
  return 0;
}
