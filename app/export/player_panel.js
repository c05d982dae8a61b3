'use strict';

/** What is told of a piece; `go` is called with the number of a neighbour that is clicked. */
function showPiece(element, bake, number, go, close) {
  element.hidden = number < 0;
  element.replaceChildren();
  if (number < 0) return;
  const thing = bake.things[number], bonds = bondsOf(bake, number);
  const button = element.appendChild(made('button', '×', 'close'));
  button.title = 'Close';
  button.onclick = close;
  element.appendChild(made('h2', thing.name));
  element.appendChild(rowsOf(factsOf(bake, thing, bonds)));
  if (bonds.length > 0) element.appendChild(bondTable(bake, bonds, go));
}

function made(tag, text = '', name = '') {
  const element = document.createElement(tag);
  element.textContent = text;
  element.className = name;
  return element;
}

/** Bonds with the neighbour's number, the first to open first. */
function bondsOf(bake, number) {
  return bake.bonds.filter(bond => bond.a === number || bond.b === number)
      .map(bond => ({...bond, neighbour: bond.a === number ? bond.b : bond.a}))
      .sort((a, b) => (a.breakTime ?? Infinity) - (b.breakTime ?? Infinity));
}

function factsOf(bake, thing, bonds) {
  const facts = [['Mass', quantity(thing.mass, 'kg')], ['Size', thing.size.map(length => quantity(length, 'm')).join(' × ')]];
  if (thing.body !== null) facts.push(['Of', bake.bodies[thing.body]]);
  if (thing.supported) facts.push(['Held', 'by a support']);
  if (thing.breakTime !== null) facts.push(['Broke off', `after ${quantity(thing.breakTime, 's')}`]);
  if (thing.brokeScaled) facts.push(['Broke at', `${thing.brokeScaled}: scaled to keep to the step budget`]);
  const first = bonds.find(bond => bond.breakTime !== null);
  if (first)
    facts.push(['Why', `its bond to ${bake.things[first.neighbour].name} gave way first, after ${quantity(first.breakTime, 's')}:` +
                       ` the tension there passed ${quantity(first.strength, 'Pa')}`]);
  return facts;
}

function rowsOf(facts) {
  const table = made('table');
  for (const [name, value] of facts) {
    const row = table.appendChild(made('tr'));
    row.append(made('th', name), made('td', value));
  }
  return table;
}

function bondTable(bake, bonds, go) {
  const table = made('table'), head = table.appendChild(made('tr'));
  for (const name of ['Held by', 'Area', 'Strength', 'Until']) head.appendChild(made('th', name));
  for (const bond of bonds) {
    const row = table.appendChild(made('tr')), link = made('button', bake.things[bond.neighbour].name, 'link');
    link.onclick = () => go(bond.neighbour);
    row.appendChild(made('td')).appendChild(link);
    const until = bond.breakTime === null ? 'now' : quantity(bond.breakTime, 's');
    for (const text of [quantity(bond.area, 'm²'), quantity(bond.strength, 'Pa'), until]) row.appendChild(made('td', text));
  }
  return table;
}

/** Draws the bar of time: a tick for each frame in which pieces broke off, the taller the more. */
function drawBar(canvas, breaks, frame) {
  const scale = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  Object.assign(canvas, {width: Math.round(scale * width), height: Math.round(scale * height)});
  const context = canvas.getContext('2d'), style = getComputedStyle(document.documentElement);
  const color = name => style.getPropertyValue(name).trim(), last = Math.max(breaks.length - 1, 1);
  context.scale(scale, scale);
  context.fillStyle = color('--line');
  context.fillRect(0, height / 2 - 1.5, width, 3);
  context.fillStyle = color('--bad');
  breaks.forEach((count, i) => {
    if (count === 0) return;
    const tall = height * Math.min(1, 0.3 + 0.13 * Math.log2(1 + count));
    context.fillRect(i / last * (width - 2), (height - tall) / 2, 2, tall);
  });
  context.fillStyle = color('--accent');
  context.fillRect(frame / last * (width - 4), 0, 4, height);
}
