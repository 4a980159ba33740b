// pmreport for several processes on several machines: mpiexec -n 8 pmreport-mpi scenario.toml
#include <reports/mpi/ranks.hpp>
#include <reports/program/answer.hpp>

int main(int argc, char** argv) {
  const pmreport::mpi::Job job(&argc, &argv);
  const std::unique_ptr<pmreport::chunks::Dealer> dealer = pmreport::mpi::dealer_of(job);
  return pmreport::program::answer_together(argc, argv, *dealer, job.threads());
}
