'use strict';
const all = (selector, root = document) => [...root.querySelectorAll(selector)];

// List pictures of one status whose names contain the search words.
let wanted = 'all';
const search = document.querySelector('.filter input');
function filter() {
  const words = search.value.toLowerCase().split(/\s+/);
  for (const picture of all('[data-status]')) {
    const isWanted = wanted === 'all' || wanted === picture.dataset.status;
    picture.hidden = !isWanted || !words.every((word) => picture.dataset.name.toLowerCase().includes(word));
  }
  for (const list of all('.passed')) {
    list.hidden = all('[data-status]', list).every((picture) => picture.hidden);
    if (wanted === 'passed' || search.value) list.open = true;
  }
}
for (const button of all('.filter button')) {
  button.addEventListener('click', () => {
    wanted = button.dataset.shows;
    for (const other of all('.filter button')) other.setAttribute('aria-pressed', other === button);
    filter();
  });
}
search.addEventListener('input', filter);

// Overlay golden and new picture: with a slider, or blinking four times a second.
for (const stage of all('.stage')) {
  const article = stage.closest('article');
  const button = article.querySelector('.blink'), slider = article.querySelector('.slider');
  stage.querySelector('.golden').src = article.querySelector('.sides .golden').src;
  stage.querySelector('.new').src = article.querySelector('.sides .new').src;
  let timer = 0;
  const show = (side) => {
    stage.classList.toggle('shows-golden', side === 'golden');
    stage.classList.toggle('shows-new', side === 'new');
  };
  const slide = () => stage.style.setProperty('--share', `${slider.value}%`);
  const blink = (on) => {
    clearInterval(timer);
    timer = 0;
    button.setAttribute('aria-pressed', on);
    stage.classList.toggle('blinks', on);
    show(on ? 'golden' : '');
    if (on) timer = setInterval(() => show(stage.classList.contains('shows-golden') ? 'new' : 'golden'), 250);
  };
  button.addEventListener('click', () => blink(!timer));
  stage.addEventListener('click', () => blink(!timer));
  slider.addEventListener('input', () => { blink(false); slide(); });
  stage.closest('.over').hidden = false;
}

// Commands are copied by a click.
for (const button of all('.command button')) {
  button.addEventListener('click', async () => {
    const code = button.parentElement.querySelector('code');
    try {
      await navigator.clipboard.writeText(code.textContent);
      button.textContent = 'Copied';
    } catch {
      getSelection().selectAllChildren(code);
      button.textContent = document.execCommand('copy') ? 'Copied' : 'Selected: press Ctrl+C';
    }
    setTimeout(() => { button.textContent = 'Copy'; }, 2000);
  });
}
