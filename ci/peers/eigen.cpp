// Eigen's sparse direct solvers behind four C functions.
//
// The pattern is analysed once, when a solver is made, as an application with a fixed pattern would;
// what is timed is the numeric factorisation and the solve, each by itself. Copying the values in and
// the solution out is not timed. Everything is left at Eigen's defaults.

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <chrono>
#include <cstdint>
#include <memory>

namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
using Vector = Eigen::VectorXd;
using Lu = Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>>;
using Ldlt = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>>;

std::uint64_t now_ns() {
    const auto t = std::chrono::steady_clock::now().time_since_epoch();
    return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(t).count());
}

struct Solver {
    virtual ~Solver() = default;
    virtual bool one(const double *values, const double *rhs, double *x, std::uint64_t *factor, std::uint64_t *solve) = 0;
    virtual long entries() const = 0;
};

template <class Method>
struct With final : Solver {
    Matrix k;
    Vector b, x;
    Method method;

    With(int n, const int *starts, const int *rows, const double *values)
        : k(Eigen::Map<const Matrix>(n, n, starts[n], starts, rows, values)), b(n), x(n) {
        method.analyzePattern(k);
    }

    bool one(const double *values, const double *rhs, double *out, std::uint64_t *factor, std::uint64_t *solve) override {
        std::copy(values, values + k.nonZeros(), k.valuePtr());
        b = Eigen::Map<const Vector>(rhs, b.size());
        const auto start = now_ns();
        method.factorize(k);
        const auto factored = now_ns();
        if (method.info() != Eigen::Success) {
            return false;
        }
        x = method.solve(b);
        *solve = now_ns() - factored;
        *factor = factored - start;
        Eigen::Map<Vector>(out, x.size()) = x;
        return method.info() == Eigen::Success;
    }

    long entries() const override { return stored(method); }

    static long stored(const Lu &m) { return static_cast<long>(m.nnzL()) + static_cast<long>(m.nnzU()); }
    static long stored(const Ldlt &m) { return static_cast<long>(m.matrixL().nestedExpression().nonZeros()); }
};

}  // namespace

extern "C" {

// 0: SparseLU with COLAMD, 1: SimplicialLDLT with AMD. Null if the pattern cannot be analysed.
void *dogleaf_eigen_new(int method, int n, const int *starts, const int *rows, const double *values) noexcept {
    try {
        std::unique_ptr<Solver> s;
        if (method == 0) {
            s = std::make_unique<With<Lu>>(n, starts, rows, values);
        } else if (method == 1) {
            s = std::make_unique<With<Ldlt>>(n, starts, rows, values);
        }
        return s.release();
    } catch (...) {
        return nullptr;
    }
}

// Factors and solves `count` matrices that lie one behind the other. Returns how many went well before one failed.
int dogleaf_eigen_run(void *solver, int count, int entries, int n, const double *values, const double *rhs, double *x,
                      std::uint64_t *factor_ns, std::uint64_t *solve_ns) noexcept {
    auto *s = static_cast<Solver *>(solver);
    try {
        for (int m = 0; m < count; ++m) {
            const auto at = static_cast<std::ptrdiff_t>(m);
            if (!s->one(values + at * entries, rhs + at * n, x + at * n, factor_ns + m, solve_ns + m)) {
                return m;
            }
        }
        return count;
    } catch (...) {
        return -1;
    }
}

// Stored entries of the factor(s) after a run.
long dogleaf_eigen_entries(const void *solver) noexcept { return static_cast<const Solver *>(solver)->entries(); }

void dogleaf_eigen_free(void *solver) noexcept { delete static_cast<Solver *>(solver); }
}
