// SPDX-License-Identifier: LGPL-2.1-or-later
// The numbers of a sparse Cholesky factor whose columns come in supernodes (columns of one pattern,
// a dense panel each), on all threads: left-looking, each supernode takes the products of those
// before it that reach it (E. Ng, B. Peyton, Block sparse Cholesky algorithms on advanced
// uniprocessor computers, 1993). Subtrees of the elimination tree are factorized at once, then the
// supernodes above them, with the products that reach each at once. What is added to what, and in
// which order, is the same as on one thread: so are the bytes.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace curveups {

// Supernodes of a pattern, ascending, as CHOLMOD's analysis stores them.
struct Supernodes {
  int count = 0;
  const int* column = nullptr;       // the first of each; one more at the end
  const int* row_begin = nullptr;    // where its rows begin in `row`; one more at the end
  const int* value_begin = nullptr;  // where its panel begins, column by column
  const int* row = nullptr;          // ascending, its own columns first
};

class SupernodalCholesky {
 public:
  // The arrays have to live as long as this.
  explicit SupernodalCholesky(const Supernodes& pattern);

  // lower: a lower triangle within the pattern, sorted. values: the factor's, panel by panel. False
  // where the matrix is not positive definite. Throws Cancelled.
  bool factorize(const Eigen::SparseMatrix<double, Eigen::ColMajor, int>& lower, double* values);

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
  struct Update;
  struct Workspace;
  struct Subtree {
    int first, root;
    std::vector<int> beyond;  // what reaches supernodes above next, in the order it got there
  };

  int columns(int s) const { return at_.column[s + 1] - at_.column[s]; }
  int rows(int s) const { return at_.row_begin[s + 1] - at_.row_begin[s]; }
  const int* row(int s) const { return at_.row + at_.row_begin[s]; }
  double* panel(int s) const { return values_ + at_.value_begin[s]; }

  void divide();
  bool factorize(Subtree& subtree, Workspace& own);
  bool factorize_above(int s, Workspace& own);
  void load(int s, std::vector<int>& place) const;
  Update update_of(int d, int s) const;
  void multiply(const Update& update, const std::vector<int>& place, double* product,
                int* target) const;
  // Columns [begin, end) of s alone.
  void subtract(const Update& update, const double* product, const int* target, int s, int begin,
                int end) const;
  bool factorize_diagonal(int s) const;
  void solve_below(int s, int begin, int end) const;
  // The next supernode that d reaches, from its row number `position` on; -1: none.
  int reach(int d, int position, int by);
  void link(int d, int s);

  Supernodes at_;
  std::vector<int> owner_;         // of each column
  std::vector<Subtree> subtrees_;  // ascending
  std::vector<int> above_;         // the other supernodes, ascending
  std::vector<int> last_;          // of those that reach a supernode next, that linked last,
  std::vector<int> before_;        // and from each the one before
  std::vector<int> position_;      // the first row that no supernode has taken yet
  std::vector<int> linked_by_;     // at which supernode's turn
  const Matrix* lower_ = nullptr;
  double* values_ = nullptr;
};

}  // namespace curveups
