"""Many runs of a scene in separate processes."""
import itertools
import os

import numpy

from .scene import Scene
from .world import World, thread_limit


def outcomes(world):
    """Returns the default outcomes of sweep(): pieces, cracks, masses [kg] and energies [J]."""
    frame = world.frame
    masses = frame.body_masses
    return {
        "pieces": len(masses),
        "cracks": len(frame.crack_steps),
        "largest_mass": float(masses.max(initial=0)),
        "smallest_mass": float(masses.min(initial=numpy.inf)),
        "kinetic_energy": frame.energy_kinetic,
        "fracture_energy": frame.energy_fracture_energy,
        "peak_utilization": float(frame.utilization.max(initial=0)),
        "state_hash": world.state_hash,
    }


def _run(scene, folder, settings, steps, measure):
    """Makes one run in a separate process."""
    edited = Scene(scene, folder) if isinstance(scene, dict) else Scene(scene)
    for pointer, value in settings.items():
        edited[pointer] = value
    with thread_limit(1):
        return {**settings, **measure(World(edited).run(steps))}


def sweep(scene, steps, vary, measure=outcomes, processes=None, progress=None):
    """Runs a scene over all combinations of values and returns a table.

    Args:
        scene: the path of a scene file or a dictionary.
        steps: time steps of each run.
        vary: values by JSON pointer: {"/projectiles/0/speed": [5, 10, 20]}.
        measure: called with the world at the end, returns a dictionary of numbers and texts. It must be a function of a module,
            since it is sent to other processes.
        processes: number of parallel runs; number of processors if None.
        progress: called with (runs made, runs) after each.

    Returns:
        A dictionary of arrays with one entry per run, in the order of itertools.product(): the varied values by their
        pointers, and the results of `measure`.

    Errors of runs are raised here; Ctrl+C ends all runs.
    """
    # Imported late: it gives the main module a second name, which programs that embed Python do not expect.
    import concurrent.futures
    import multiprocessing

    source = scene.get() if isinstance(scene, Scene) else scene
    grid = [dict(zip(vary, values)) for values in itertools.product(*vary.values())]
    context = multiprocessing.get_context("spawn")  # threads of the library do not survive a fork
    pool = concurrent.futures.ProcessPoolExecutor(processes or os.cpu_count(), mp_context=context)
    try:
        jobs = [pool.submit(_run, source, os.getcwd(), settings, steps, measure) for settings in grid]
        for made, _ in enumerate(concurrent.futures.as_completed(jobs), 1):
            if progress:
                progress(made, len(jobs))
        rows = [job.result() for job in jobs]
    finally:
        pool.shutdown(wait=True, cancel_futures=True)
    return {key: numpy.array([row[key] for row in rows]) for key in (rows[0] if rows else vary)}
