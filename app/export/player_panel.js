'use strict';

/** Shows the facts about a piece; `go` is called with the number of a clicked neighbor. */
function showPiece(element, bake, number, go, close) {
  element.hidden = number < 0;
  element.replaceChildren();
  if (number < 0) return;
  const object = bake.objects[number], bonds = bondsOf(bake, number);
  const button = element.appendChild(made('button', '×', 'close'));
  button.title = 'Close';
  button.onclick = close;
  element.appendChild(made('h2', object.name));
  element.appendChild(rowsOf(factsOf(bake, object, bonds)));
  if (bonds.length > 0) element.appendChild(bondTable(bake, bonds, go));
}

function made(tag, text = '', name = '') {
  const element = document.createElement(tag);
  element.textContent = text;
  element.className = name;
  return element;
}

/** Bonds with the neighbor's number, in order of opening. */
function bondsOf(bake, number) {
  return bake.bonds.filter(bond => bond.a === number || bond.b === number)
      .map(bond => ({...bond, neighbor: bond.a === number ? bond.b : bond.a}))
      .sort((a, b) => (a.breakTime ?? Infinity) - (b.breakTime ?? Infinity));
}

function factsOf(bake, object, bonds) {
  const facts = [['Mass', quantity(object.mass, 'kg')], ['Size', object.size.map(length => quantity(length, 'm')).join(' × ')]];
  if (object.body !== null) facts.push(['Body', bake.bodies[object.body]]);
  if (object.supported) facts.push(['Held', 'by a support']);
  if (object.breakTime !== null) facts.push(['Broke off', `after ${quantity(object.breakTime, 's')}`]);
  if (object.brokeScaled) facts.push(['Broke at', `${object.brokeScaled}: scaled for the step budget`]);
  const first = bonds.find(bond => bond.breakTime !== null);
  if (first)
    facts.push(['Why', `its bond to ${bake.objects[first.neighbor].name} opened first, after ${quantity(first.breakTime, 's')}:` +
                       ` the tension there exceeded ${quantity(first.strength, 'Pa')}`]);
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
  for (const name of ['Bond to', 'Area', 'Strength', 'Until']) head.appendChild(made('th', name));
  for (const bond of bonds) {
    const row = table.appendChild(made('tr')), link = made('button', bake.objects[bond.neighbor].name, 'link');
    link.onclick = () => go(bond.neighbor);
    row.appendChild(made('td')).appendChild(link);
    const until = bond.breakTime === null ? 'now' : quantity(bond.breakTime, 's');
    for (const text of [quantity(bond.area, 'm²'), quantity(bond.strength, 'Pa'), until]) row.appendChild(made('td', text));
  }
  return table;
}

/** Draws the timeline: a tick for each frame in which pieces broke off, taller for more of them. */
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
