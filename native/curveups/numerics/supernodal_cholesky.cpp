// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curveups/numerics/supernodal_cholesky.hpp"

#include <cblas.h>

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "curveups/core/parallel.hpp"
#include "curveups/numerics/one_thread.hpp"

// LAPACK's, which has no header here.
extern "C" void dpotrf_(  // NOLINT(readability-identifier-naming)
    const char* triangle, const int* n, double* a, const int* stride, int* info);

namespace curveups {
namespace {

// Operations below which threads cost more than they save, and the largest share of all that a
// subtree has.
constexpr double least_divided = 2e7, largest_share = 0.125;
// Rows of a panel that are solved for at once above the subtrees.
constexpr int rows_at_once = 256;
// Numbers that products take at once (64 MB), where they are more than two.
constexpr std::size_t most_products = 8 << 20;

}  // namespace

// What supernode d takes from another: the product of its rows from `first` on with those of them
// that are the other's columns.
struct SupernodalCholesky::Update {
  int d, first, width, height;
  std::size_t size() const { return static_cast<std::size_t>(width) * height; }
};

struct SupernodalCholesky::Workspace {
  explicit Workspace(std::size_t all_rows) : place(all_rows) {}
  void reserve(std::size_t products, std::size_t targets) {
    if (static_cast<std::size_t>(product.size()) < products) product.resize(products);
    if (target.size() < targets) target.resize(targets);
  }
  std::vector<int> place;   // of a row in the panel at hand
  Eigen::VectorXd product;  // of updates; not filled with zeros first
  std::vector<int> target;  // their rows' places
};

SupernodalCholesky::SupernodalCholesky(const Supernodes& pattern)
    : at_(pattern),
      owner_(pattern.count > 0 ? pattern.column[pattern.count] : 0),
      last_(pattern.count),
      before_(pattern.count),
      position_(pattern.count),
      linked_by_(pattern.count) {
  for (int s = 0; s < at_.count; ++s) {
    std::fill(owner_.begin() + at_.column[s], owner_.begin() + at_.column[s + 1], s);
  }
  divide();
}

// Into subtrees of consecutive supernodes, as they are in postorder, and what is above them.
void SupernodalCholesky::divide() {
  std::vector<double> cost(at_.count, 0);
  std::vector<int> first(at_.count), size(at_.count, 1);
  double all = 0;
  for (int s = 0; s < at_.count; ++s) first[s] = s;
  for (int s = 0; s < at_.count; ++s) {
    double own = 0;
    for (int k = 0; k < columns(s); ++k) own += static_cast<double>(rows(s) - k) * (rows(s) - k);
    all += own;
    cost[s] += own;
    if (rows(s) == columns(s)) continue;
    const int parent = owner_[row(s)[columns(s)]];
    cost[parent] += cost[s];
    size[parent] += size[s];
    first[parent] = std::min(first[parent], first[s]);
  }
  const double most = all < least_divided ? all : largest_share * all;
  for (int s = at_.count - 1; s >= 0;) {
    if (cost[s] <= most && s - first[s] + 1 == size[s]) {
      subtrees_.push_back({first[s], s, {}});
      s = first[s] - 1;
    } else {
      above_.push_back(s--);
    }
  }
  std::reverse(subtrees_.begin(), subtrees_.end());
  std::reverse(above_.begin(), above_.end());
}

bool SupernodalCholesky::factorize(const Matrix& lower, double* values) {
  lower_ = &lower;
  values_ = values;
  std::fill(last_.begin(), last_.end(), -1);
  std::atomic<bool> definite{true};
  parallel_ranges(static_cast<int>(subtrees_.size()), [&](int begin, int end) {
    const OneThread guard;
    Workspace own(owner_.size());
    for (int i = begin; i < end && definite; ++i) {
      if (!factorize(subtrees_[i], own)) definite = false;
    }
  });
  if (!definite) return false;
  for (const Subtree& subtree : subtrees_) {
    for (int d : subtree.beyond) link(d, owner_[row(d)[position_[d]]]);
  }
  Workspace own(above_.empty() ? 0 : owner_.size());
  for (int s : above_) {
    if (!factorize_above(s, own)) return false;
  }
  return true;
}

bool SupernodalCholesky::factorize(Subtree& subtree, Workspace& own) {
  subtree.beyond.clear();
  const auto pass_on = [&](int d, int position, int by) {
    const int next = reach(d, position, by);
    if (next > subtree.root) subtree.beyond.push_back(d);
    if (next >= 0 && next <= subtree.root) link(d, next);
  };
  for (int s = subtree.first; s <= subtree.root; ++s) {
    load(s, own.place);
    for (int d = last_[s], next = -1; d >= 0; d = next) {
      next = before_[d];
      const Update update = update_of(d, s);
      own.reserve(update.size(), update.height);
      multiply(update, own.place, own.product.data(), own.target.data());
      subtract(update, own.product.data(), own.target.data(), s, 0, columns(s));
      pass_on(d, update.first + update.width, s);
    }
    if (!factorize_diagonal(s)) return false;
    solve_below(s, columns(s), rows(s));
    pass_on(s, columns(s), s);
  }
  return true;
}

// As one after another: the products of some that reach s at once, then its columns.
bool SupernodalCholesky::factorize_above(int s, Workspace& own) {
  load(s, own.place);
  std::vector<int> reaching;
  for (int d = last_[s]; d >= 0; d = before_[d]) reaching.push_back(d);
  // Those below subtrees came before those above them that have lower numbers.
  std::stable_sort(reaching.begin(), reaching.end(),
                   [&](int a, int b) { return linked_by_[a] > linked_by_[b]; });
  std::vector<Update> updates;
  std::vector<std::size_t> product_begin, target_begin;
  for (std::size_t begin = 0; begin < reaching.size(); begin += updates.size()) {
    updates.clear();
    product_begin.clear();
    target_begin.clear();
    std::size_t products = 0, targets = 0;
    for (std::size_t k = begin; k < reaching.size(); ++k) {
      const Update update = update_of(reaching[k], s);
      if (k > begin + 1 && products + update.size() > most_products) break;
      updates.push_back(update);
      product_begin.push_back(products);
      target_begin.push_back(targets);
      products += update.size();
      targets += static_cast<std::size_t>(update.height);
    }
    own.reserve(products, targets);
    const auto product = [&](int k) { return own.product.data() + product_begin[k]; };
    const auto target = [&](int k) { return own.target.data() + target_begin[k]; };
    const int count = static_cast<int>(updates.size());
    parallel_ranges(count, [&](int from, int to) {
      const OneThread guard;
      for (int k = from; k < to; ++k) multiply(updates[k], own.place, product(k), target(k));
    });
    parallel_ranges(columns(s), [&](int from, int to) {
      for (int k = 0; k < count; ++k) subtract(updates[k], product(k), target(k), s, from, to);
    });
    for (const Update& update : updates) {
      const int next = reach(update.d, update.first + update.width, s);
      if (next >= 0) link(update.d, next);
    }
  }
  {
    const OneThread guard;
    if (!factorize_diagonal(s)) return false;
  }
  const int below = rows(s) - columns(s);
  parallel_ranges((below + rows_at_once - 1) / rows_at_once, [&](int from, int to) {
    const OneThread guard;
    for (int k = from; k < to; ++k) {
      const int begin = columns(s) + k * rows_at_once;
      solve_below(s, begin, std::min(rows(s), begin + rows_at_once));
    }
  });
  const int next = reach(s, columns(s), s);
  if (next >= 0) link(s, next);
  return true;
}

void SupernodalCholesky::load(int s, std::vector<int>& place) const {
  const int height = rows(s), first = at_.column[s];
  for (int k = 0; k < height; ++k) place[row(s)[k]] = k;
  double* to = panel(s);
  std::fill(to, to + static_cast<std::ptrdiff_t>(height) * columns(s), 0.0);
  for (int c = first; c < at_.column[s + 1]; ++c, to += height) {
    for (Matrix::InnerIterator it(*lower_, c); it; ++it) to[place[it.row()]] = it.value();
  }
}

SupernodalCholesky::Update SupernodalCholesky::update_of(int d, int s) const {
  const int first = position_[d], height = rows(d) - first;
  const int* begin = row(d) + first;
  const int* end = std::lower_bound(begin, begin + height, at_.column[s + 1]);
  return {d, first, static_cast<int>(end - begin), height};
}

void SupernodalCholesky::multiply(const Update& update, const std::vector<int>& place,
                                  double* product, int* target) const {
  const auto& [d, first, width, height] = update;
  const double* from = panel(d) + first;
  cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, width, columns(d), 1, from, rows(d), 0,
              product, height);
  if (height > width) {
    cblas_dgemm(CblasColMajor, CblasNoTrans, CblasTrans, height - width, width, columns(d), 1,
                from + width, rows(d), from, rows(d), 0, product + width, height);
  }
  for (int k = 0; k < height; ++k) target[k] = place[row(d)[first + k]];
}

void SupernodalCholesky::subtract(const Update& update, const double* product, const int* target,
                                  int s, int begin, int end) const {
  for (int c = 0; c < update.width; ++c) {
    if (target[c] < begin || target[c] >= end) continue;
    double* to = panel(s) + static_cast<std::ptrdiff_t>(target[c]) * rows(s);
    const double* from = product + static_cast<std::ptrdiff_t>(c) * update.height;
    for (int k = c; k < update.height; ++k) to[target[k]] -= from[k];
  }
}

bool SupernodalCholesky::factorize_diagonal(int s) const {
  const int width = columns(s), height = rows(s);
  int info = 0;
  dpotrf_("L", &width, panel(s), &height, &info);
  return info == 0;
}

void SupernodalCholesky::solve_below(int s, int begin, int end) const {
  if (begin == end) return;
  cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, end - begin,
              columns(s), 1, panel(s), rows(s), panel(s) + begin, rows(s));
}

int SupernodalCholesky::reach(int d, int position, int by) {
  position_[d] = position;
  linked_by_[d] = by;
  return position < rows(d) ? owner_[row(d)[position]] : -1;
}

void SupernodalCholesky::link(int d, int s) {
  before_[d] = last_[s];
  last_[s] = d;
}

}  // namespace curveups
