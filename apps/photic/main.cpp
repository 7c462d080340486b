// photic: the command line. Everything thrown is reported here and becomes an exit code.
#include <fmt/format.h>

#include <exception>
#include <new>

#include "core/error.hpp"
#include "photic/command_line.hpp"
#include "photic/output.hpp"
#include "photic/terminal.hpp"

namespace {

using namespace photic;

/// The file whose problems are counted; none where the command line itself is what was wrong.
struct Subject {
  const InputError& error;

  std::string operator()(const app::RunCommand& c) const {
    return error.diagnostics().front().file == c.earlier ? c.earlier : c.scene;
  }
  std::string operator()(const app::BenchCommand& c) const { return c.scene; }
  std::string operator()(const app::CheckCommand& c) const { return c.scene; }
  std::string operator()(const app::ShowCommand& c) const { return c.file; }
  std::string operator()(const app::OpticsCommand& c) const { return c.scene; }
  /// The subject of commands that read no scene.
  template <class Other>
  std::string operator()(const Other& /*c*/) const {
    return {};
  }
};

void report(const InputError& error, const std::string& subject) {
  app::print_problems(error.diagnostics());
  const std::size_t count = error.diagnostics().size();
  if (!subject.empty())
    app::print_error(
        app::painted(fmt::format("{} problem{} in {}", count, count == 1 ? "" : "s", subject),
                     app::Colour::red, app::Stream::error) +
        '\n');
}

void failure(const std::string& reason) {
  app::print_error(app::painted("photic: " + reason, app::Colour::red, app::Stream::error) + '\n');
}

int follow(const app::Command& command) {
  try {
    return std::visit([](const auto& c) { return app::run(c); }, command);
  } catch (const InputError& error) {
    report(error, std::visit(Subject{error}, command));
    return app::bad_input;
  } catch (const UsageError& error) {
    app::print_error(app::painted(error.what(), app::Colour::red, app::Stream::error) + '\n');
    return app::bad_input;
  } catch (const EnvironmentError& error) {
    failure(error.what());
  } catch (const std::bad_alloc&) {
    failure("not enough memory (fewer gates, orders or telescopes need less)");
  } catch (const std::exception& error) {
    failure(fmt::format("this is a bug, please report it: {}", error.what()));
  }
  return app::failed;
}

}  // namespace

int main(int argc, char** argv) {
  const app::Parsed parsed = app::parse_command_line(argc, argv);
  return parsed.command ? follow(*parsed.command) : parsed.exit_code;
}
