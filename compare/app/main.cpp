#include <fmt/format.h>
#include <spdlog/sinks/ostream_sink.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>

#include "compare/app/command_line.hpp"
#include "compare/study/errors.hpp"
#include "dem/model/errors.hpp"
#include "dem/run/memory.hpp"
#include "dem/scene/scene_error.hpp"
#include "dem/trajectory/h5md.hpp"
#include "reference/errors.hpp"
#include "reference/gsl_status.hpp"

namespace {

using namespace fiberchain;
using namespace fiberchain::app;

/// Messages as "fiberchain: text", warnings and errors with their level.
std::shared_ptr<spdlog::logger> make_log() {
  auto log = std::make_shared<spdlog::logger>("fiberchain",
                                              std::make_shared<spdlog::sinks::ostream_sink_st>(std::cerr));
  log->set_pattern("%n: %v");
  return log;
}

int report(const std::exception& error, int status) {
  std::string message = error.what();
  std::ranges::replace_if(
      message, [](unsigned char c) { return c < 0x20; }, ' ');
  std::cerr << "fiberchain: error: " << message << std::endl;
  return status;
}

int run(const std::vector<std::string>& command_line) {
  Context context{dem::collect_provenance(command_line), std::cout, std::cerr, make_log(),
                  dem::someone_watches()};
  const Request request = parse_command_line({command_line.begin() + 1, command_line.end()});
  context.out << request.text;
  const int status = request.command ? request.command->run(request.arguments, context) : kSuccess;
  if (!std::cout.flush()) throw dem::OutputError("standard output", "is it closed, or its disk full?");
  return status;
}

}  // namespace

int main(int count, char** arguments) {
  reference::report_gsl_errors_by_status();
  dem::leave_hdf5_as_it_is_at_exit();
  std::signal(SIGPIPE, SIG_IGN);  // who reads the messages may leave: the run goes on
  std::signal(SIGXFSZ, SIG_IGN);  // a file-size limit shall be an error of the write, not the end
  try {
    return run({arguments, arguments + count});
  } catch (const compare::InputError& error) {
    return report(error, kBadInput);
  } catch (const dem::SceneError& error) {
    return report(error, kBadInput);
  } catch (const dem::InvalidInput& error) {
    return report(error, kBadInput);
  } catch (const reference::InvalidArgument& error) {
    return report(error, kBadInput);
  } catch (const std::bad_alloc&) {
    return report(std::runtime_error("out of memory" + dem::memory_in_words()), kRunFailed);
  } catch (const std::exception& error) {
    return report(error, kRunFailed);
  }
}
