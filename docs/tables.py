#!/usr/bin/env python3
"""Writes the tables of figures and the outputs of commands in docs/*.md, or compares a cheap row of each with its page.

  docs/tables.py                    writes all tables except those of machine time
  docs/tables.py impacts energy     writes some; --list names them all
  docs/tables.py --times            writes those of machine time, on a quiet machine
  docs/tables.py --check            compares one row of each table with its page; exit code 1 if one differs

A page has its tables between <!-- table NAME --> and <!-- end -->. Each table is an entry of TABLES."""
import argparse
import concurrent.futures
import csv
import dataclasses
import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time
from typing import Callable

DOCS = pathlib.Path(__file__).resolve().parent
SCENES = DOCS.parent / 'scenes'


@dataclasses.dataclass
class Row:
    """A row of a table: the cells that name it, and a function of the others."""
    key: tuple
    make: Callable[[], list]


@dataclasses.dataclass
class Table:
    name: str
    page: str
    header: str
    rows: Callable[[], list]        # all Rows
    checked: tuple = ()             # key of the row that --check computes
    tolerance: float = 1e-9         # relative, of its figures: another build gives the same means
    is_time: bool = False           # of a machine: written with --times or by name, never checked
    text: Callable[[bool], str] = None  # instead of rows: returns the whole text, or (True) lines that must be in it


class Program:
    """The built programs."""
    build = DOCS.parent / 'build/release'

    @classmethod
    def path(cls, name):
        return str(cls.build / {'griffith': 'app/griffith', 'validation': 'tests/validation/validation'}.get(name, name))

    @classmethod
    def simulate(cls, scene, frames, settings=()):
        """Runs a scene (a path or a dictionary). Returns its statistics and the last row of its energy account."""
        with tempfile.TemporaryDirectory() as folder:
            path = scene
            if isinstance(scene, dict):
                path = folder + '/scene.json'
                pathlib.Path(path).write_text(json.dumps({'version': 1, **scene}))
            options = [part for setting in settings for part in ('--set', setting)]
            stats, energy = folder + '/stats.json', folder + '/energy.csv'
            run([cls.path('griffith'), 'simulate', str(path), '--frames', str(frames), '--threads', '1', '--stats', stats,
                 '--energy', energy, *options])
            with open(energy, newline='') as file:
                last = list(csv.DictReader(file))[-1]
            account = {name.split(' [')[0]: float(value) for name, value in last.items()}
            return json.loads(pathlib.Path(stats).read_text()), account


def run(command):
    done = subprocess.run(command, capture_output=True, text=True, cwd=SCENES.parent)
    if done.returncode != 0 and 'find' not in command[1:2]:
        raise RuntimeError(' '.join(command) + '\n' + done.stderr.strip()[-500:])
    return done.stdout


# ---- impacts: a struck plate over speeds, steps and budgets

SHOTS = 6


def struck_plate(speed, step, budget, shot):
    return {'gravity': [0, 0, 0], 'ground': None, 'simulation': {'time_step': step, 'step_budget': budget},
            'bodies': [{'name': 'plate', 'material': 'concrete', 'elements': 'linear',  # quadratic ones are not scaled
                        'shape': {'box': {'size': [1, 1, .1], 'element_size': [.1, .1, .05], 'pattern': 'five_tet'}}}],
            'projectiles': [{'position': [.03 + .01 * shot, .05 - .015 * shot, .16], 'direction': [0, 0, -1],
                             'speed': speed, 'mass': 5, 'radius': .08}]}


def impact(speed, step, budget):
    factor, pieces, area = 1, 0, 0
    for shot in range(SHOTS):
        stats, account = Program.simulate(struck_plate(speed, step, budget, shot), math.ceil(.05 / step - 1e-9))
        factor = min([factor] + [scaled['factor'] for scaled in stats['scaled_impacts']])
        pieces += stats['bodies'] / SHOTS
        area += account['crack_area'] / SHOTS
    return [f'{factor:.3f}', f'{pieces:.0f}', f'{area:.2f}']


def impacts():
    rows = []
    for speed, step, budget in [(9, 60, 10), (9, 60, 1000), (9, 1000, 10), (9, 10000, 10), (15, 30, 10), (15, 60, 10),
                                (15, 60, 1000), (15, 250, 10), (15, 1000, 10), (15, 10000, 10), (30, 60, 10),
                                (30, 60, 1000), (30, 1000, 10), (30, 10000, 10)]:
        limit = 'no limit' if budget == 1000 else str(budget)
        rows.append(Row((f'{speed} m/s', f'1/{step} s', limit), lambda s=speed, t=1 / step, b=budget: impact(s, t, b)))
    return rows


# ---- energy: where it went, in percent of what was put in

def energies():
    rows = []
    for path in sorted(SCENES.glob('*.json')):
        scene = json.loads(path.read_text())
        if path.name == 'scene.schema.json':
            continue
        is_static = scene.get('analysis') == 'static'
        for integrator in ['static'] if is_static else ['implicit', 'hybrid']:
            settings = [] if is_static else [f'simulation/integrator="{integrator}"']
            rows.append(Row((path.stem, integrator), lambda p=path, s=settings: energy(p, s)))
    return rows


def energy(path, settings):
    account = Program.simulate(path, 60, settings)[1]
    put_in = sum(account[name] for name in ('start', 'gravity', 'loads', 'supports', 'projectiles', 'edits'))
    percent = lambda digits, *names: f'{100 * sum(account[name] for name in names) / put_in + 0:.{digits}f}'
    short = lambda *names: re.sub(r'^-?0\.0$', '0', percent(1, *names))
    joules = f'{put_in:.3g} J' if put_in < 1e3 else f'{put_in / 1e3:.3g} kJ'
    return [joules, short('kinetic', 'elastic'), short('fracture'), short('contacts'), short('material_damping'),
            short('microstep_damping'), short('time_integration'), short('hand_over', 'limited'), short('scaling'),
            percent(3, 'unaccounted'), short('fracture_energy')]


# ---- weak_walls: the damage of a wall over its properties

WALL_SHOTS = [(-.9, -.3, .04), (.2, .5, -.06), (1.1, -.6, .02), (-.3, .7, -.02), (.6, .1, .08)]
BRICKWORK = {'preset': 'brick', 'tensile_strength': 60e3, 'fracture_toughness': 45e3}


def wall_damage(speed, changes):
    area = 0
    for x, y, faster in WALL_SHOTS:
        wall = {'name': 'wall', 'material': 'brickwork', 'position': [0, 3, 0],
                'shape': {'box': {'size': [6, 6, 1], 'element_size': 1, 'pattern': 'five_tet'}},
                'supports': [{'region': {'half_space': {'point': [0, -3, 0], 'normal': [0, -1, 0]}}}]}
        shot = {'start': .02, 'position': [x, 3.8 + y, 2], 'direction': [0, 0, -1], 'speed': speed * (1 + faster)}
        scene = {'materials': {'brickwork': {**BRICKWORK, **changes}}, 'bodies': [wall], 'projectiles': [shot]}
        area += Program.simulate(scene, 60)[1]['crack_area'] / len(WALL_SHOTS)
    return 'none' if area == 0 else f'{area:.2g} m²'


def weak_walls():
    def row(title, speed, unit, field, values, why, **more):
        scale = {'GPa': 1e9, 'kPa': 1e3, 'kPa√m': 1e3, 'kN': 1e3}.get(unit, 1)
        damage = lambda value: wall_damage(speed, {field: scale * value, **more})
        return Row((title, f'{speed} m/s'), lambda: [f'{v:g} {unit}: '.replace(' :', ':') + damage(v) for v in values] + [why])
    return [
        row("Young's modulus", 9, 'GPa', 'young_modulus', (55, 16, 5),
            'A stiff wall stops the shot in less time, so with more force: stress goes with v√(Eρ). Strength is a stress; '
            'a soft wall just bends.'),
        row("Poisson's ratio", 12, '', 'poisson_ratio', (.45, .25, .05),
            'A plate that cannot contract laterally is stiffer, E/(1 − ν²), and bending in one direction stresses it in the '
            'other one too.'),
        row('density', 7, 'kg/m³', 'density', (500, 1000, 2000),
            "The shot's momentum moves a heavy wall less, so it bends less. (The first impact's stress grows as √ρ, but "
            'bending breaks the wall.)'),
        row('tensile strength', 9, 'kPa', 'tensile_strength', (40, 60, 90), 'It is the resistance.'),
        row('fracture toughness', 9, 'kPa√m', 'fracture_toughness', (15, 30, 45),
            'Cracks start at the same load, then stop sooner. Where elements are smaller than (K_Ic/σ_t)², the strength decides '
            'at the front as well.'),
        row('separation toughness', 15, 'kN', 'separation_toughness', (15, 30, 60),
            'The resistance of `separation_force`.', criterion='separation_force')]


# ---- ceiling: bodies of small and flat elements under budgets

def ball_of_slivers(budget):
    """A bowl of thin walls, filled by a lattice whose surface elements are small, thrown at the ground."""
    return {'simulation': {'time_step': 1 / 60, 'step_budget': budget},
            'bodies': [{'name': 'vase', 'material': 'concrete', 'elements': 'linear', 'position': [0, .4, 0], 'velocity': [0, -10, 0],
                        'shape': {'surface': {'path': str(SCENES / 'meshes/vase.obj'), 'element_size': .1}}}]}


def ceilings():
    rows = []
    for budget in (1, 10, 100, 1000):
        rows.append(Row((str(budget),), lambda b=budget: ceiling(b)))
    return rows


def ceiling(budget):
    stats, account = Program.simulate(ball_of_slivers(budget), 20)
    factor = min([1] + [scaled['factor'] for scaled in stats['scaled_impacts']])
    return [f'{stats["microstep_work"]:.0f}', f'{factor:.3f}', str(stats['relieved_tets']),
            str(stats['unfinished_explicit']), str(stats['bodies']), f'{account["crack_area"]:.2f}']


# ---- validation: the page of closed forms, by the program that is their test

def validation(is_check):
    return run([Program.path('validation')] + (['BarInTension'] if is_check else [])).strip()


# ---- output of commands, as code

def griffith(arguments):
    """Returns the command as a reader types it, and its output without the path of the program."""
    output = run([Program.path('griffith'), *shlex.split(arguments)])
    return f'$ griffith {arguments}', output.replace(Program.path('griffith'), 'griffith')


def as_code(lines):
    return '\n'.join('    ' + text if text else '' for text in lines)


def explanation(is_check):
    with tempfile.TemporaryDirectory() as folder:
        arguments = 'render scenes/brick_wall.json --frame 28 --view candidate_plane+element_forces --node 161 -o '
        _, output = griffith(arguments + folder + '/why.png')
    return as_code(output.splitlines() if is_check else [f'$ griffith {arguments}why.png', *output.splitlines()])


# ---- quantities: those of views, from the program's own table

def quantities(_):
    lines = griffith('render --list-views')[1].split('\n\n')[0].splitlines()
    rows = [re.split(r'  +', text) if '  ' in text else [text] for text in lines[1:]]
    name_of = lambda row: [f'`{row[0]}`', row[1] if len(row) > 2 else '', row[-1]]
    return '\n'.join(['| name | per | meaning |', '|---|---|---|', *(line(name_of(row)) for row in rows)])


@dataclasses.dataclass
class Search:
    """A run of `griffith find`, of whose table a page shows the rows at the ends and at changes."""
    scene: str      # with the options before the parameter
    parameter: str
    values: str     # its range or list; empty: the search widens from the value of the scene
    rest: str       # options that follow
    checked: str    # values whose rows --check makes

    def run(self, values):
        assignment = self.parameter + ('=' + values if values else '')
        return griffith(f'find {self.scene} --parameter {assignment} {self.rest}')

    def __call__(self, is_check):
        if is_check:
            return as_code(self.run(self.checked)[1].splitlines()[:1 + len(self.checked.split(','))])
        command, output = self.run(self.values)
        table, _, rest = output.partition('\n\n')
        short = [text for text in rest.splitlines() if text.strip() and len(text) < 100]
        return as_code([*wrapped(command), *shortened(table.splitlines()), '', *short[:4]])


def wrapped(command):
    """Returns the lines of a command, broken before the options that do not fit."""
    lines = ['']
    for part in re.split(r' (?=--)', command):
        if len(lines[-1] + part) > 116:
            lines[-1] += ' \\'
            lines.append('   ')
        lines[-1] += (' ' if lines[-1] else '') + part
    return lines


def shortened(table):
    """Returns heading, first and last row, and the rows at changes of yes and no; the others become one line of dots."""
    heading, *rows = table
    answers = [re.findall(r'\b(?:yes|no)\b', row) for row in rows]
    changes = [i for i in range(1, len(rows)) if answers[i] != answers[i - 1]]
    if not any(answers):
        changes = range(1, len(rows))
    kept = sorted({0, len(rows) - 1, *changes, *(i - 1 for i in changes)})
    lines = [heading]
    for before, i in zip([-1, *kept], kept):
        lines += (['…'] if i > before + 1 else []) + [rows[i]]
    return lines


breaking_speed = Search('scenes/glass_pane.json --frames 30', 'projectiles/0/speed', '', '--outcome "pieces > 1"', '1.5625,400')
probabilities = Search('scenes/glass_pane.json --frames 30', 'projectiles/0/speed', '1,2,4,8',
                       '--outcome "pieces > 1" --set \'bodies/0/strength_scatter={"weibull_modulus": 7}\' --seeds 20', '1')
window = Search('scenes/wall_small.json --frames 60', 'bodies/0/material/tensile_strength', '1e4:1e6',
                '--outcome "projectiles/0/speed=14: pieces == 1" --outcome "projectiles/0/speed=40: pieces in 8:12"',
                '10000,1e+06')


# ---- times of a machine

def bench(scene, frames, settings=(), repeats=2):
    with tempfile.TemporaryDirectory() as folder:
        options = [part for setting in settings for part in ('--set', setting)]
        run([Program.path('griffith'), 'bench', str(scene), '--frames', str(frames), '--repeats', str(repeats), '--json',
             folder + '/bench.json', *options])
        return json.loads(pathlib.Path(folder + '/bench.json').read_text())['runs']


def swaying():
    rows = []
    for tets, size, frames in [('500', [.2, .2, .25], 200), ('2,250', [2 / 15, 2 / 15, .125], 200),
                               ('10,240', [.0625, .0625, .125], 100), ('54,080', [2 / 52, 2 / 52, .0625], 60),
                               ('201,720', [2 / 82, 2 / 82, .25 / 6], 30)]:
        rows.append(Row((tets,), lambda s=size, f=frames: sway(s, f)))
    return rows


def sway(size, frames):
    setting = f'bodies/0/shape/box/element_size={json.dumps(size)}'
    one, two = bench(SCENES / 'validation/swaying_wall.json', frames, [setting], 3)
    step = one['ms']['step']
    return [f'{step["median"]:.3g}', f'{1e6 * step["median"] / one["tets"]:.0f}', str(one['solver_iterations']),
            f'{two["ms"]["step"]["mean"]:.3g} ({step["mean"]:.3g})']


def scene_times():
    names = ['arch', 'bridge', 'brick_wall', 'column_collapse', 'glass_pane', 'plate_drop', 'spot_shot', 'vase_shot',
             'wall_large', 'walls_16', 'wood_beam', 'walls_32']
    return [Row((name,), lambda n=name: scene_time(n)) for name in names if (SCENES / f'{name}.json').exists()]


def scene_time(name):
    one = bench(SCENES / f'{name}.json', 120)[0]
    ms, mean = one['ms'], lambda phase: f'{one["ms"][phase]["mean"]:.2g}'
    return [f'{one["tets"]:,}', str(one['pieces']), f'{ms["step"]["median"]:.2g}', f'{ms["step"]["p99"]:.0f}',
            f'{ms["step"]["max"]:.0f}', ', '.join(map(mean, ('contact', 'elasticity', 'explicit')))]


TABLES = [
    Table('impacts', 'fracture.md', '| speed | step | budget | lowest f | pieces | crack area, m² |', impacts,
          ('15 m/s', '1/60 s', '10'), .3),
    Table('ceiling', 'fracture.md',
          '| budget, ms | most work of a step, ms | lowest f | relieved elements | unfinished substeps | pieces | crack area, m² |',
          ceilings, ('1',), .5),
    Table('energy', 'fracture.md',
          '| scene | integrator | supplied | stored | fracture | contacts | material | microsteps | time integration | '
          'regime change, limits | scaling | unaccounted | fracture energy |', energies, ('block_stack', 'hybrid'), .1),
    Table('weak_walls', 'fracture.md', '| property | shot | weak wall | regular wall | strong wall | why |', weak_walls,
          ('tensile strength', '9 m/s'), .5),
    Table('quantities', 'views.md', '', None, text=quantities),
    Table('validation', 'validation.md', '', None, text=validation),
    Table('explanation', 'tutorial.md', '', None, tolerance=.1, text=explanation),
    Table('breaking_speed', 'sweeps.md', '', None, tolerance=.3, text=breaking_speed),
    Table('probabilities', 'sweeps.md', '', None, tolerance=.3, text=probabilities),
    Table('window', 'sweeps.md', '', None, tolerance=.3, text=window),
    Table('swaying', 'performance.md',
          '| tetrahedra | median ms | ns per tetrahedron (median) | most iterations | '
          'two threads, wall-clock ms, mean (of one) |', swaying, is_time=True),
    Table('scene_times', 'performance.md',
          '| scene | tetrahedra | pieces at the end | median | 99 % | longest | mean of contact, elasticity, explicit |',
          scene_times, is_time=True),
]


def line(cells):
    return '| ' + ' | '.join(cells) + ' |'


def made(table):
    """Returns the whole table as Markdown. Rows run in parallel, except for times."""
    if table.text:
        return table.text(False)
    rows = table.rows()
    with concurrent.futures.ThreadPoolExecutor(1 if table.is_time else os.cpu_count()) as pool:
        lines = list(pool.map(lambda row: line([*row.key, *row.make()]), rows))
    return '\n'.join([table.header, '|' + '---|' * (table.header.count('|') - 1), *lines])


def parts(table):
    """Returns the table's page before, between and after its marks."""
    page = (DOCS / table.page).read_text()
    begin, end = f'<!-- table {table.name} -->\n', '<!-- end -->'
    if page.count(begin) != 1:
        raise RuntimeError(f'docs/{table.page} needs one line {begin.strip()}')
    first = page.index(begin) + len(begin)
    last = page.index(end, first)
    return page[:first], page[first:last], page[last:]


def figures(text):
    return [float(word.replace(',', '')) for word in re.findall(r'(?<![\w.])-?\d[\d,]*\.?\d*(?:e-?\d+)?', text)]


def alike(now, said, tolerance):
    """True if two rows have the same figures, to within the tolerance and a unit of the last digit."""
    ours, theirs = figures(now), figures(said)
    unit = lambda text: .6 if '.' not in text else .06
    return len(ours) == len(theirs) and all(
        abs(a - b) <= tolerance * max(abs(a), abs(b)) + unit(now) for a, b in zip(ours, theirs))


def same_words(now, said):
    return re.sub(r'[\d.,]+', ' ', now).split() == re.sub(r'[\d.,]+', ' ', said).split()


def check(table):
    """Returns the difference between the page and the cheap row; empty if they agree."""
    said = parts(table)[1]
    if table.text:
        is_alike = lambda now, text: now == text or (
            table.tolerance > 1e-6 and same_words(now, text) and alike(now, text, table.tolerance))
        missing = [now for now in table.text(True).splitlines() if not any(is_alike(now, text) for text in said.splitlines())]
        return f'{table.name}: docs/{table.page} lacks\n' + '\n'.join(missing) if missing else ''
    row = next(row for row in table.rows() if row.key == table.checked)
    now = line([*row.key, *row.make()])
    found = [text for text in said.splitlines() if text.startswith(line(row.key)[:-1])]
    if len(found) == 1 and alike(now, found[0], table.tolerance):
        return ''
    return f'{table.name}: docs/{table.page} says\n  {found}\nnow it is\n  {now}'


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('names', nargs='*', metavar='NAME', choices=[[], *(table.name for table in TABLES)])
    parser.add_argument('--check', action='store_true', help='compare a row of each with the page')
    parser.add_argument('--times', action='store_true', help='make the tables of machine time')
    parser.add_argument('--list', action='store_true', help='list the tables and their pages')
    parser.add_argument('--build', type=pathlib.Path, default=Program.build, help='folder of the build (build/release)')
    arguments = parser.parse_args()
    Program.build = arguments.build
    chosen = [table for table in TABLES if table.name in arguments.names] if arguments.names else [
        table for table in TABLES if table.is_time == arguments.times]
    if arguments.list:
        return print('\n'.join(f'{table.name:15} docs/{table.page}' + (' (times)' if table.is_time else '') for table in TABLES))
    if arguments.check:
        differing = [text for text in (check(table) for table in chosen if not table.is_time) if text]
        return sys.exit('\n'.join(differing) + '\nMake it again: docs/tables.py NAME' if differing else 0)
    for table in chosen:
        start = time.monotonic()
        text = made(table)
        before, _, after = parts(table)
        (DOCS / table.page).write_text(before + text + '\n' + after)
        print(f'{table.name}: docs/{table.page}, {time.monotonic() - start:.0f} s', flush=True)


if __name__ == '__main__':
    main()
