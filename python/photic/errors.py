"""What can go wrong, as the user is told it."""


class Error(Exception):
    """The message says what and which file; exit_code as in the program: 2 bad input, 1 failed
    environment."""

    def __init__(self, message, exit_code=2):
        super().__init__(message)
        self.exit_code = exit_code
