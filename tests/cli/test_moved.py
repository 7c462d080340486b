"""A result carries all that its scene is made of: the folder may move, or the tables be gone."""

import shutil

import pytest
from test_reproducible import contents

# Isotropic; 1/(4 pi) is 0.0795775.
TABLE = "angle_deg,phase_function_per_sr\n0,0.0795775\n90,0.0795775\n180,0.0795775\n"
OTHER_TABLE = "angle_deg,phase_function_per_sr\n0,0.0795775\n90,0.0795776\n180,0.0795775\n"
ALGAE = "wavelength_nm,a_m2_per_mg,b_m2_per_mg\n400,0.04,0.3\n800,0.02,0.25\n"
FILTER = "wavelength_nm,transmission\n525,0\n532,0.7\n540,0.1\n"
YIELDS = "excitation_nm,emission_nm,yield_per_nm\n532,540,1e-4\n532,600,2e-5\n532,700,0\n"


@pytest.fixture
def campaign(scene, tmp_path):
    """A folder with a scene that names files by all keys there are for them."""
    folder = tmp_path / "campaign"
    folder.mkdir()
    for name, text in {"vsf.csv": TABLE, "algae.csv": ALGAE, "filter.csv": FILTER, "eem.csv": YIELDS}.items():
        (folder / name).write_text(text)
    text = scene.read_text()
    text = text.replace("[[sea.layer]]\nchlorophyll_mg_m3 = 1.0\n", LAYERS).replace(CHANNEL, CHANNELS)
    (folder / "lib.toml").write_text(text + '[[environment]]\nset = { "optics.phytoplankton_file" = "algae.csv" }\n')
    return folder


CHANNEL = '[[channel]]\nname = "raman"\nprocess = "raman"\n'
CHANNELS = CHANNEL + '[[channel]]\nname = "filter"\ntransmission_file = "filter.csv"\n'
LAYERS = """\
[[sea.layer]]
iop = [{ wavelength_nm = 500.0, a_per_m = 0.1, b_per_m = 0.2 }, { wavelength_nm = 800.0, a_per_m = 0.3, b_per_m = 0.2 }]
phase_function = { model = "table", file = "vsf.csv" }
[optics]
phytoplankton = "table"
phytoplankton_file = "algae.csv"
cdom_fluorescence = "table"
cdom_fluorescence_file = "eem.csv"
"""


BATCH = ["--set", "simulation.batch_photons=500"]  # of 20000 photons


def test_a_result_is_shown_and_gone_on_from_where_its_folder_has_moved(photic, campaign, tmp_path):
    long_run = photic("run", "lib.toml", "--photons", "40000", "-o", "../long.nc", *BATCH, cwd=campaign)
    assert long_run.returncode == 0, long_run.stderr
    assert photic("run", "lib.toml", "-o", "out.nc", cwd=campaign).returncode == 0
    shown = photic("show", "out.nc", cwd=campaign)
    moved = tmp_path / "archive"
    shutil.move(campaign, moved)

    again = photic("show", "archive/out.nc")
    assert again.returncode == 0, again.stderr
    assert again.stdout.replace("archive/", "") == shown.stdout
    assert ".csv" not in again.stdout
    going_on = ["run", "lib.toml", "--continue", "out.nc", "--photons", "40000", "-o", "new.nc"]
    done = photic(*going_on, cwd=moved)
    assert done.returncode == 0, done.stderr
    assert contents(moved / "new.nc")[0] == contents(tmp_path / "long.nc")[0]

    for name in ("vsf.csv", "algae.csv", "filter.csv", "eem.csv", "lib.toml"):
        (moved / name).unlink()
    done = photic("run", "--continue", "out.nc", "--photons", "40000", "-o", "alone.nc", cwd=moved)
    assert done.returncode == 0, done.stderr
    assert contents(moved / "alone.nc")[0] == contents(tmp_path / "long.nc")[0]


def test_another_table_under_the_same_name_is_another_scene(photic, campaign):
    assert photic("run", "lib.toml", "-o", "out.nc", cwd=campaign).returncode == 0
    (campaign / "vsf.csv").write_text(OTHER_TABLE)
    done = photic("run", "lib.toml", "--continue", "out.nc", "--photons", "40000", cwd=campaign)
    assert done.returncode == 2
    assert (
        "out.nc: sea.layer.1.phase_function.file.phase_function_per_sr.1 was 0.0795775 and is 0.0795776 now" in done.stderr
    )
