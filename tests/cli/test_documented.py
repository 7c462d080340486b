"""What README and the guide say to type works as written, with an installed Photic and from any folder."""

import pytest
from conftest import SOURCE
from documented import commands_to_run, run_all

PAGE = """\
Text.
```sh
echo "one of $PWD" >out
```
```
what it prints
```
```sh (not run: needs root)
sudo something
```
```console
$ cat out   # and a remark
what it prints
```
"""


PAGES = ["README.md", "docs/guide.md", *sorted(f"docs/howto/{path.name}" for path in (SOURCE / "docs/howto").glob("*.md"))]


@pytest.mark.parametrize("page", PAGES)
def test_commands_of(page, tmp_path, installed_environment, prefix):
    # Seen red: with `photic new ships` in README, `photic --versions` in the guide, `surfaces` for `surface` in waves.md.
    assert commands_to_run(SOURCE / page), f"{page}: no block is tagged ```sh"
    python = {"PYTHONPATH": str(prefix / "lib/python3/dist-packages")}  # as "Install" in the guide says
    done = run_all(SOURCE / page, tmp_path, installed_environment | python)
    assert done.returncode == 0, done.stderr


def test_commands_are_taken_from_pages_in_order_and_run_in_one_folder(tmp_path, installed_environment):
    page = tmp_path / "page.md"
    page.write_text(PAGE)
    assert [commands.line for commands in commands_to_run(page)] == [3, 12]
    done = run_all(page, tmp_path, installed_environment)
    assert (done.returncode, done.stdout) == (0, f"one of {tmp_path}\n")


def test_a_command_that_fails_is_reported_with_its_place(tmp_path, installed_environment):
    page = tmp_path / "page.md"
    page.write_text(PAGE.replace("$ cat out", "$ false | cat; echo on"))
    done = run_all(page, tmp_path, installed_environment)
    assert done.returncode == 1
    place, *pipe = done.stderr.splitlines()[-3:]  # of a pipe the shell prints the parts in any order
    assert (place, sorted(pipe)) == ("+ : page.md:12", ["+ cat", "+ false"])
    assert done.stdout == ""


@pytest.mark.parametrize("tag", ["bash", "shell", "sh (not run)", "sh (not run: )", "sh quick"])
def test_tags_that_say_too_little_are_refused(tmp_path, tag):
    page = tmp_path / "page.md"
    page.write_text(f"```{tag}\nphotic new ship\n```\n")
    with pytest.raises(ValueError, match=r"page.md:2: "):
        commands_to_run(page)
