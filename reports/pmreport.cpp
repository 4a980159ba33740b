#include <reports/program/answer.hpp>

int main(int argc, char** argv) { return pmreport::program::answer(argc, argv); }
