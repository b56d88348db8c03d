"""Threads, forks, pickles and Ctrl-C."""

import os
import pickle
import signal
import subprocess
import sys
import textwrap
import threading
import time

import groundwave as gw
import pytest
import xarray as xr

CASE = {"soil": "lamprea2022_layered", "surface_compliance": {"k": [0.1, 1.0], "frequencies": [5.0, 10.0]}}

#: Work of half a minute or more, one for each kind of item between which it may be told to stop.
LONG = {
    "critical_speed": 'gw.critical_speed(**line, speeds=slice(10, 200, 0.01))',
    "contour": 'gw.contour(**line, speeds=slice(60, 100, 0.5), x=slice(-40, 20), y=slice(-30, 30), spacing=0.25)',
    "ground_at_depth": 'gw.ground_at_depth(**line, speeds=slice(20, 100, 0.2), z=slice(0.5, 5, 0.1))',
    "free_field": 'gw.free_field(**line, speed=30.0, receivers=[10.0, 20.0, 40.0], irregularity={"kind": "german", '
    '"quality": "low", "wavelengths": slice(0.5, 80), "profiles": 1000})',
    "passage": 'gw.passage(foundation=gw.Springs("winkler", stiffness=1.8e8, damping=2e5), '
    'track=gw.Track(kind="beam", beam={"bending_stiffness": 6.4e6, "mass": 60.0}), train="lamprea2022_axle", '
    'speed=30.0, from_=0.0, to=5000.0)',
}


def test_pickles():
    case = gw.Case(CASE)
    again = pickle.loads(pickle.dumps(case))
    assert (again.text, again.files, again.studies) == (case.text, case.files, case.studies)
    xr.testing.assert_identical(again.run(), case.run())
    for table in [
        gw.Soil("lamprea2022_layered"),
        gw.Track("lamprea2022_ballasted", pad={"stiffness": 3e8}),
        gw.Train("lamprea2022_axle", count=1),
        gw.Springs("winkler", stiffness=1e8),
    ]:
        again = pickle.loads(pickle.dumps(table))
        assert type(again) is type(table) and again.table == table.table


def test_other_threads_go_on():
    """While a computation runs, another Python thread counts: the lock is free."""
    case = gw.Case({"soil": "lamprea2022_layered", "track": "lamprea2022_ballasted", "train": "lamprea2022_axle",
                    "critical_speed": {"speeds": slice(10, 200, 0.05)}})
    done = threading.Event()
    worker = threading.Thread(target=lambda: (case.run(), done.set()))
    worker.start()
    ticks = 0
    while not done.is_set() and ticks < 20:
        time.sleep(0.01)
        ticks += 1
    assert ticks == 20, "the computation was over, or held the lock, before twenty hundredths of a second"
    worker.join()


def test_threads_ask_at_the_same_time():
    wanted = gw.Case(CASE).run()
    found = [None] * 8

    def ask(i):
        found[i] = gw.Case(CASE).run()

    workers = [threading.Thread(target=ask, args=(i,)) for i in range(len(found))]
    [worker.start() for worker in workers]
    [worker.join(60) for worker in workers]
    for one in found:
        xr.testing.assert_identical(one, wanted)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork on this system")
def test_children_of_a_fork_compute():
    """A pool of threads does not survive fork: the child has its own."""
    script = """
        import os, groundwave as gw
        case = gw.Case({"soil": "lamprea2022_layered", "surface_compliance": {"k": [0.1], "frequencies": [5.0]}})
        first = case.run()["surface_compliance"].u_zz.item()
        child = os.fork()
        if child == 0:
            again = case.run()["surface_compliance"].u_zz.item()
            grandchild = os.fork()
            if grandchild == 0:
                os._exit(0 if case.run()["surface_compliance"].u_zz.item() == again else 4)
            os._exit(os.waitstatus_to_exitcode(os.waitpid(grandchild, 0)[1]) if again == first else 3)
        raise SystemExit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
    """
    assert subprocess.run([sys.executable, "-W", "ignore", "-c", textwrap.dedent(script)], timeout=60).returncode == 0


@pytest.mark.parametrize("study", LONG)
def test_an_interrupt_ends_within_a_second(study):
    script = f"""
        import sys, time, warnings
        import groundwave as gw
        warnings.simplefilter("ignore")
        line = dict(soil="lamprea2022_layered", track="lamprea2022_ballasted",
                    train=gw.Train("lamprea2022_axle", unsprung_mass=1800.0, wheel_rail={{"radius": 0.46}}))
        print("begun", flush=True)
        try:
            {LONG[study]}
        except KeyboardInterrupt:
            print("interrupted", time.time(), flush=True)
            import os
            os._exit(0)
        print("ended", time.time())
    """
    child = subprocess.Popen([sys.executable, "-c", textwrap.dedent(script)], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "begun\n"
    time.sleep(0.7)
    sent = time.time()
    child.send_signal(signal.SIGINT)
    word, moment = child.communicate(timeout=30)[0].split()
    assert word == "interrupted", "the work was over before it was told to stop"
    # measured 0.02 to 0.4 s: what does not stop at its next step is not waited for longer
    assert float(moment) - sent < 1.0


def test_progress_is_told_and_may_stop():
    told = []

    class Enough(Exception):
        pass

    def tell(what, done, steps):
        told.append((what, done, steps))
        if done > 3:
            raise Enough

    with pytest.raises(Enough):
        gw.critical_speed(soil="lamprea2022_layered", track="lamprea2022_ballasted", train="lamprea2022_axle",
                          speeds=slice(10, 200, 0.05), progress=tell)
    assert told[-1][0] == "critical speed" and told[-1][2] > 3800
