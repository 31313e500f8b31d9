#include "compare/app/stop_signals.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(stop_signals_test)

using fiberchain::app::StopSignals;

namespace {

void (*handler(int signal))(int) {
  struct sigaction now {};
  ::sigaction(signal, nullptr, &now);
  return now.sa_handler;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_signal_is_remembered_while_it_lives) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    std::signal(signal, SIG_DFL);
    {
      const StopSignals stop;
      BOOST_TEST(stop.received() == 0);
      std::raise(signal);
      BOOST_TEST(stop.received() == signal);
      BOOST_TEST((handler(signal) == SIG_DFL));  // the second one ends the program
    }
    const StopSignals next;
    BOOST_TEST(next.received() == 0);
  }
  BOOST_TEST((handler(SIGINT) == SIG_DFL));
  BOOST_TEST((handler(SIGTERM) == SIG_DFL));
}

BOOST_AUTO_TEST_CASE(what_was_ignored_stays_ignored) {
  std::signal(SIGINT, SIG_IGN);
  const StopSignals stop;
  std::raise(SIGINT);
  BOOST_TEST(stop.received() == 0);
  std::raise(SIGTERM);
  BOOST_TEST(stop.received() == SIGTERM);
}

BOOST_AUTO_TEST_SUITE_END()
