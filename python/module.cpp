#include "bind.hpp"

PYBIND11_MODULE(_scanfuse, module) {
  using namespace scanfuse::python;
  module.doc() = "The compiled part of scanfuse.";
  module.attr("__version__") = SCANFUSE_VERSION;
  py::register_exception<Failure>(module, "Error", PyExc_ValueError).attr("__doc__") =
      "What went wrong and what to do about it; the command line prints the same text.";
  bind_data(module);
  bind_results(module);
  bind_chain(module);
  bind_files(module);
  bind_scoring(module);
  bind_passive(module);
  bind_turntable(module);
}
