"""Photic's claims of accuracy and speed, measured, and the pages that report it."""
