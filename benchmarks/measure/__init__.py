"""What Photic claims of its accuracy and its speed, measured, and the pages that report it."""
