"""Policies in processes of their own leave nothing behind: neither when they are ended, nor when we are."""

import os
import pathlib
import signal
import subprocess
import sys
import time

import pytest

import marketgen
import policies
from marketgen import confinement
from marketgen.policy_process import PolicyFailed, PolicyProcess

confined = pytest.mark.skipif(confinement.version() == 0, reason="this kernel has no Landlock")
LONG_S = 60  # that anything here may take on a loaded machine; it takes a hundredth


def runs(pid):
    """A zombie that waits for init runs no more, either."""
    try:
        stat = pathlib.Path(f"/proc/{pid}/stat").read_text()
    except OSError:
        return False
    return stat.rpartition(") ")[2][0] not in "ZX"


def until(holds):
    end = time.monotonic() + LONG_S
    while not holds() and time.monotonic() < end:
        time.sleep(0.05)
    return holds()


def pids_in(file):
    """The policy's and its child's."""
    assert until(lambda: file.exists() and file.read_text().count(" ") == 1)
    return [int(word) for word in file.read_text().split()]


def zombies():
    mine = []
    for entry in pathlib.Path("/proc").iterdir():
        try:
            state, parent = (entry / "stat").read_text().rpartition(") ")[2].split()[:2]
        except (OSError, ValueError):
            continue
        mine += [entry.name] if int(parent) == os.getpid() and state == "Z" else []
    return mine


@pytest.mark.parametrize("seen", ["None", pytest.param("sight([], files=[sys.argv[2]])", marks=confined)])
def test_kill_nine_takes_the_policy_and_its_children_along(tmp_path, seen):
    script = (
        "import sys; from marketgen.policy_process import PolicyProcess; import policies; "
        "from marketgen.policy_sight import sight; "
        f"PolicyProcess(policies.Stuck(sys.argv[1]), 1000, sight={seen}).ask('act', None)"
    )
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    files = [str(tmp_path / "pids"), str(tmp_path)]
    evaluator = subprocess.Popen([sys.executable, "-c", script, *files], env=environment)
    pids = pids_in(tmp_path / "pids")
    assert all(map(runs, pids))
    evaluator.send_signal(signal.SIGKILL)
    evaluator.wait()
    assert until(lambda: not any(map(runs, pids)))


def test_children_do_not_outlive_the_limit(tmp_path):
    player = PolicyProcess(policies.Stuck(str(tmp_path / "pids")), 3)
    with pytest.raises(PolicyFailed, match="act_limit_s") as caught:
        player.ask("act", None)
    assert caught.value.code == "episode.policy_slow"
    assert until(lambda: not any(map(runs, pids_in(tmp_path / "pids"))))
    assert zombies() == []


@pytest.mark.parametrize("payload", [0, 10_000_000])
def test_a_policy_that_never_starts_is_an_error_in_time(payload):
    with pytest.raises(marketgen.Error, match="after 2 s of wall time") as caught:
        PolicyProcess(policies.HangsAtImport(payload), 100, hang_limit_s=2).ask("act", None)
    assert caught.value.code == "episode.no_policy"
    assert zombies() == []


def test_the_start_is_measured_by_what_it_computes():
    with pytest.raises(marketgen.Error, match="after 3 s of processor time .start_limit_s") as caught:
        PolicyProcess(policies.ComputesAtImport(), 100, start_limit_s=3).ask("act", None)
    assert caught.value.code == "episode.no_policy"
    assert zombies() == []


def test_one_that_is_broken_as_it_starts_says_why():
    with pytest.raises(marketgen.Error, match="ZeroDivisionError") as caught:
        PolicyProcess(policies.BreaksAtImport(), 100).ask("act", None)
    assert caught.value.code == "episode.no_policy"


def test_large_policies_and_answers_come_through():
    player = PolicyProcess(policies.Echo(bytes(10_000_000)), 100)
    assert player.ask("act", bytes(5_000_000)) == 15_000_000
    player.close()
    assert zombies() == []


def test_time_in_which_it_does_not_compute_is_not_counted():
    player = PolicyProcess(policies.Waits(), act_limit_s=0.5)
    assert player.ask("act", 1.5) == 1.5
    player.close()


def test_one_that_waits_for_ever_hangs_and_is_not_called_slow():
    with pytest.raises(PolicyFailed, match="hang_limit_s") as caught:
        PolicyProcess(policies.Waits(), act_limit_s=100, hang_limit_s=5).ask("act", 1000)
    assert caught.value.code == "episode.policy_hung"


def test_an_answer_that_took_too_much_is_too_late_though_it_came():
    player = PolicyProcess(policies.Computes(), act_limit_s=1)
    assert player.ask("act", 0.5) == 0.5
    assert player.ask("act", 0.5) == 0.5, "each answer has the whole of the limit"
    with pytest.raises(PolicyFailed, match="act_limit_s") as caught:
        player.ask("act", 1.1)
    assert caught.value.code == "episode.policy_slow"
