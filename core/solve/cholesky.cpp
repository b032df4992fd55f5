#include "core/solve/cholesky.h"

#include <cholmod.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace stipple {

namespace {

// The serial BLAS hands out its buffers without locks: two threads in it at once give wrong numbers, even on
// different factors (seen beside an abandoned factorization). One lock for the process, as the buffers are
// one.
std::mutex& blasMutex() {
  static std::mutex mutex;
  return mutex;
}

// Workspace and settings of CHOLMOD. Silent: libraries never print.
struct Workspace {
  cholmod_common common;

  Workspace() {
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    // Asked for explicitly: the default strategy tries METIS, six times slower than what it saves.
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    common.postorder = true;
  }
  ~Workspace() { cholmod_finish(&common); }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
};

// The lower triangle of a full symmetric matrix; its compressed rows are the compressed columns of the
// transpose.
cholmod_sparse viewOf(const SparseMatrix& matrix) {
  cholmod_sparse view{};
  view.nrow = matrix.rows();
  view.ncol = matrix.cols();
  view.nzmax = matrix.nonZeros();
  view.p = const_cast<int*>(matrix.outerIndexPtr());
  view.i = const_cast<int*>(matrix.innerIndexPtr());
  view.x = const_cast<double*>(matrix.valuePtr());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = true;
  view.packed = true;
  return view;
}

}  // namespace

struct CholeskyFactor::Impl {
  mutable Workspace workspace;
  cholmod_factor* factor = nullptr;
  std::vector<int> rowStarts, columns;  ///< pattern that the ordering belongs to

  ~Impl() { cholmod_free_factor(&factor, &workspace.common); }

  bool samePattern(const SparseMatrix& m) const {
    return factor &&
           std::equal(rowStarts.begin(), rowStarts.end(), m.outerIndexPtr(),
                      m.outerIndexPtr() + m.rows() + 1) &&
           std::equal(columns.begin(), columns.end(), m.innerIndexPtr(), m.innerIndexPtr() + m.nonZeros());
  }
  void throwOutOfMemory(Eigen::Index rows) const {
    throw SolverError(fmt::format("not enough memory for the factorization of a matrix with {} rows", rows));
  }
};

CholeskyFactor::CholeskyFactor() : impl_(std::make_unique<Impl>()) {}
CholeskyFactor::~CholeskyFactor() = default;

void CholeskyFactor::factorize(const SparseMatrix& matrix) {
  const std::lock_guard lock(blasMutex());
  Impl& self = *impl_;
  cholmod_common& common = self.workspace.common;
  cholmod_sparse view = viewOf(matrix);
  if (!self.samePattern(matrix)) {
    cholmod_free_factor(&self.factor, &common);
    self.factor = cholmod_analyze(&view, &common);
    if (!self.factor) self.throwOutOfMemory(matrix.rows());
    self.rowStarts.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.rows() + 1);
    self.columns.assign(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros());
  }
  const int done = cholmod_factorize(&view, self.factor, &common);
  if (common.status == CHOLMOD_NOT_POSDEF) {
    const auto* order = static_cast<const int*>(self.factor->Perm);
    throw SolverError(
        fmt::format("the matrix is not positive definite: the factorization broke down at row {}",
                    order[self.factor->minor]));
  }
  if (!done || common.status < CHOLMOD_OK) self.throwOutOfMemory(matrix.rows());
}

void CholeskyFactor::solve(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> x) const {
  const std::lock_guard lock(blasMutex());
  cholmod_dense rhs{};
  rhs.nrow = b.rows();
  rhs.ncol = b.cols();
  rhs.d = b.outerStride();
  rhs.nzmax = rhs.d * rhs.ncol;
  rhs.x = const_cast<double*>(b.data());
  rhs.xtype = CHOLMOD_REAL;
  rhs.dtype = CHOLMOD_DOUBLE;
  Workspace workspace;  // its own: the factor is only read, so that threads may share it
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, impl_->factor, &rhs, &workspace.common);
  if (!solution) impl_->throwOutOfMemory(b.rows());
  x = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>(
      static_cast<const double*>(solution->x), b.rows(), b.cols(), Eigen::OuterStride<>(solution->d));
  cholmod_free_dense(&solution, &workspace.common);
}

void factorizeInterruptibly(std::shared_ptr<CholeskyFactor>& factor, const SparseMatrix& matrix,
                            const Progress* progress) {
  // Below this many rows the factorization takes less than a tenth of a second.
  constexpr Eigen::Index kQuickRows = 20000;
  if (!progress || matrix.rows() < kQuickRows) {
    if (progress) progress->throwIfCancelled();
    factor->factorize(matrix);
    return;
  }
  // CHOLMOD knows no callback: the work owns copies of all it needs, so that it may outlive this call.
  std::packaged_task<void()> work([factor, matrix] { factor->factorize(matrix); });
  std::future<void> done = work.get_future();
  std::thread(std::move(work)).detach();
  while (done.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready) {
    if (progress->cancelled()) {
      factor = std::make_shared<CholeskyFactor>();
      throw Cancelled();
    }
  }
  done.get();
}

}  // namespace stipple
