"""The style of all pictures."""

from pathlib import Path

from photic import panels

SCENES = Path(__file__).resolve().parents[2] / "scenes"
WIDTH = 7.5  # inches; 800 pixels wide, letters of 9 points are 13 pixels high
LETTERS = {"font.size": 9, "axes.titlesize": 10, "axes.titlelocation": "left", "axes.labelsize": 9}
NOTE = {"fontsize": 8.5, "color": "0.15"}
ARROW = {"arrowstyle": "->", "color": "0.3", "linewidth": 0.9, "shrinkA": 1, "shrinkB": 2}


def emptied(panel):
    """Without the frame above and at the right."""
    panel.spines[["top", "right"]].set_visible(False)
    panels.grid(panel)


def downwards(panel, bottom):
    """From the surface to a depth [m]."""
    panel.set_ylim(bottom, 0)
    panel.set_yticks(range(0, int(bottom) + 1, 5 if bottom < 40 else 10))
    panel.set_ylabel("depth [m]")
