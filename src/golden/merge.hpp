#pragma once
// Several runs: the shards of one suite as one run, and the history of a suite.
#include "golden/run.hpp"

#include <nlohmann/json_fwd.hpp>

namespace sr::golden {

/// The results of shards as one run.
struct MergedRun {
    RunResult result;
    RunRecord record; // of the shard that began first, with the times of all
    std::vector<std::string> remarks;
};

/// Merges the output folders of shards into the output folder of `options`: copies their candidates and logs.
/// A chosen test that no folder has becomes `broken`, so that a shard which was lost fails the run.
/// @throws Error if no folder has results, a folder has those of another suite or of another version of its
/// file, a test is in two folders or not in the suite, or the shards are of different commits: then nothing
/// in the output folder has changed. Also if a file cannot be copied.
MergedRun merge_shards(const Suite& suite, const std::vector<std::filesystem::path>& folders,
                       const RunOptions& options);

/// One run of a history.
struct PastRun {
    std::filesystem::path folder;
    RunResult result;
    std::optional<RunRecord> record;
};

/// Reads the output folders of runs, the earliest first; those without a record keep their places before the
/// others. @throws Error if a folder has no results, or they are of different suites.
std::vector<PastRun> read_history(const std::vector<std::filesystem::path>& folders);

/// One line a test: its outcomes from the earliest run on (". F M B ~ U", and "-" where it was not run), its
/// share of passes, and its median time.
std::string history_text(const std::vector<PastRun>& runs);

/// The same with commits, dates and messages.
nlohmann::ordered_json history_json(const std::vector<PastRun>& runs);

} // namespace sr::golden
