#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/invocation.h"
#include "app/document/journal.h"
#include "app/document/stroke.h"
#include "app/jobs/task_progress.h"
#include "app/jobs/worker_threads.h"
#include "app/plugins/loader.h"
#include "app/window/open_scan.h"
#include "app/window/process_state.h"

namespace stipple {

/// The open scans, and all that is done to them: by the user at once, by tasks and processes meanwhile. Knows
/// no widgets. Everything that can fail ends in one sentence, see said().
class Workbench final : public QObject {
  Q_OBJECT

 public:
  struct Options {
    HistoryOptions history;
    std::filesystem::path journals;                 ///< empty: none are kept
    std::shared_ptr<PluginSentinel> sentinel = {};  ///< watches plugins at work
  };

  Workbench(LoadedPlugins plugins, Options options);
  ~Workbench() override;

  const Registry& registry() const { return *registry_; }
  PluginSentinel* sentinel() const { return options_.sentinel.get(); }
  const std::vector<std::string>& pluginWarnings() const { return pluginWarnings_; }

  // Scans
  OpenScan* current() const;
  int currentIndex() const { return current_; }
  const std::vector<std::unique_ptr<OpenScan>>& scans() const { return scans_; }
  void setCurrent(int index);
  /// Reads on a worker; the scan appears when it is there.
  void open(const std::filesystem::path& path, bool isSample = false);
  void openSample();
  /// What programs that broke down left behind, latest first.
  std::vector<LostWork> lostWork() const;
  /// Reads and replays on a worker; the scan appears with its history when it is there.
  void recover(const LostWork& work);
  void close(int index);
  void closeAll();
  /// Writes on a worker.
  void save(const std::filesystem::path& path);
  bool isSaving() const { return saving_ != nullptr; }
  /// Waits for a save that is going on. False where it failed.
  bool finishSaving();

  // Edits of the current scan
  void commit(const std::string& title, const PointSet& after, std::optional<Recipe::Step> step = {});
  void undo();
  void redo();
  void goTo(std::size_t position);
  void flipNormals();
  void deleteSelection();
  enum class Widening { kGrow, kShrink };
  /// By the points next to its rim. Neighbors are found on a worker when they are first needed; what is
  /// wanted meanwhile follows in its order.
  void widenSelection(Widening widening);
  /// Plays on a worker; one entry of the history for each step.
  void play(const Recipe& recipe);
  /// After strokes and other changes made on the document itself; while a stroke goes on only what shows the
  /// surface is told.
  enum class Change { kGoesOn, kDone };
  void tellPointsChanged(Change change = Change::kDone);

  // Processes
  void run(const Invocation& invocation, bool startsPaused = false);
  bool isRunning() const { return job_ != nullptr; }
  /// The scan that the process works on; null where none runs.
  OpenScan* processScan() const;
  std::optional<ProcessState> process() const;
  void pause();
  void resume();
  void togglePause();
  void stepOnce();
  void stop();
  void cancel();
  void setProcessParameters(const Parameters& parameters);

  /// Asks for the distances along the surface of the current scan; pointsReady() follows.
  void prepareDistance();
  bool isPreparing() const { return preparing_ != nullptr; }
  /// What goes on besides processes: "reading bunny.ply", with how much of it is done.
  std::optional<TaskStatus> task() const;
  void cancelTask();

  /// Of several lines, the first is the sentence, and all of them are the details.
  void say(const QString& sentence, const QString& details = {});

 signals:
  void scansChanged();
  /// Before another scan becomes the current one, or this one goes.
  void leavingCurrent();
  void currentChanged();
  void pointsChanged();
  /// A stroke goes on: values of some points changed.
  void pointsTouched();
  /// A running process has another state to show.
  void previewChanged(const PointSet& state);
  /// The document shows again.
  void previewEnded();
  void processChanged();
  void taskChanged();
  void distanceReady();
  /// A file was read or written: it belongs to the recent ones.
  void opened(const QString& path);
  void saved();
  void said(const QString& sentence, const QString& details);

 private:
  struct Opening;
  struct Recovering;
  struct Saving;
  struct Preparing;
  struct Linking;
  struct Playing;
  struct RunningJob;

  void tick();
  void followOpening();
  void followRecovering();
  void followSaving();
  void followPreparing();
  void followLinking();
  void followPlaying();
  void followJob();
  void finishJob();
  void commitJob();
  void showResult(OpenScan& scan, const std::string& operatorId, const std::vector<Edit::Touched>& touched);
  std::string makeTitle(const std::string& operatorId) const;
  std::unique_ptr<PluginSentinel::Watch> watchPlugin(const std::string& operatorId) const;
  void takeMessages();
  void keepTicking();
  void commitEdit(const std::string& title, Edit edit, std::optional<Recipe::Step> step = {});
  bool refuseAcrossProcess(std::size_t position);
  void addScan(ReadResult read, const std::filesystem::path& path, bool isSample);
  void showScan(std::unique_ptr<OpenScan> scan);
  void keepJournal(OpenScan& scan);
  bool isBusyWith(const OpenScan& scan) const;

  std::shared_ptr<const Registry> registry_;
  std::vector<std::string> pluginWarnings_;
  std::map<std::string, std::filesystem::path> pluginFiles_;  // of operators
  Options options_;
  WorkerThreads threads_;
  std::vector<std::unique_ptr<OpenScan>> scans_;
  int current_ = -1;
  std::vector<std::unique_ptr<Opening>> openings_;
  std::unique_ptr<Recovering> recovering_;
  std::unique_ptr<Saving> saving_;
  std::unique_ptr<Preparing> preparing_;
  std::unique_ptr<Linking> linking_;
  std::unique_ptr<Playing> playing_;
  std::unique_ptr<RunningJob> job_;
  QTimer timer_;
};

}  // namespace stipple
