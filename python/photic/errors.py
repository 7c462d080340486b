"""Errors, as reported to the user."""


class Error(Exception):
    """The message says what and which file; exit_code as in the program: 2 bad input, 1 failed
    environment, 143 ended by SIGTERM. partial: the result so far, of a run that was ended."""

    def __init__(self, message, exit_code=2, partial=None):
        super().__init__(message)
        self.exit_code = exit_code
        self.partial = partial


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a run. partial: the result so far, as photic.open gives it."""

    def __init__(self, message, partial):
        super().__init__(message)
        self.partial = partial
