// The product page: passes choices to the element, and shows its events on the page. It only uses
// the element's public attributes, events and methods.
import {centsFor, metresFor, money} from './price.mjs';

const form = document.querySelector('#product');
if (form) sell(form);

function sell(form) {
  const garment = form.querySelector('seamwise-garment');
  const find = (id) => document.getElementById(id);
  const [status, problem, flat, place, add] = ['progress', 'problem', 'flat', 'place', 'add'].map(
    find,
  );

  const chosen = (name) => form.querySelector(`input[name="${name}"]:checked`).value;

  function choose({target}) {
    if (target.name === 'size') garment.size = target.value;
    if (target.name === 'print') {
      for (const colours of form.querySelectorAll('.colours')) {
        colours.hidden = colours.dataset.print !== target.value;
        if (!colours.hidden) garment.clothWidth = Number(colours.dataset.width);
      }
      garment.print = `/prints/${target.value}.json`;
    }
    const print = chosen('print');
    garment.colourway = chosen(`colourway-${print}`);
    if (garment.dataset.design) return;
    const address = new URL(location.href); // for reloads and shared links
    address.searchParams.set('size', chosen('size'));
    address.searchParams.set('print', print);
    address.searchParams.set('colourway', garment.colourway);
    history.replaceState(null, '', address);
  }

  const say = (sentence) => {
    if (status.textContent !== sentence) status.textContent = sentence;
  };

  /** @param error  an event's detail, or a method's rejection */
  function complain({code, message}) {
    const isOurs = ['not-found', 'network', 'timeout'].includes(code);
    const apology = isOurs ? 'We could not fetch the pattern or its print. ' : '';
    problem.firstElementChild.textContent = `${apology}${message}`;
    problem.hidden = false;
    if (garment.state === 'error') say('The print is not on the pieces yet.');
  }

  /**
   * Shows the price of the fabric; no price until it is known, as that of an earlier design no
   * longer applies.
   */
  function tellPrice() {
    const {clothLengthCm: lengthCm, clothWidth} = garment;
    const isKnown = lengthCm !== null;
    form.elements.cents.value = isKnown ? centsFor(lengthCm) : '';
    find('price').textContent = isKnown ? money(centsFor(lengthCm)) : '…';
    find('length').textContent = isKnown
      ? `Cut from ${metresFor(lengthCm).toFixed(2)} m of cloth, ${clothWidth} cm wide.`
      : 'Its pieces are being laid on the cloth.';
  }

  function tellFit({fit, fitRandom}) {
    const share = Math.round(100 * (1 - fit / fitRandom));
    say(`The print meets ${share} % better than if it lay as it fell.`);
  }

  form.addEventListener('change', (event) => {
    if (event.target !== garment) choose(event);
  });
  for (const target of form.querySelectorAll('input:checked')) {
    if (!target.defaultChecked) choose({target}); // changed before this script ran
  }
  garment.addEventListener('load', () => {
    problem.hidden = true;
  });
  garment.addEventListener('progress', ({detail: {phase, fraction}}) => {
    tellPrice();
    const quarter = Math.floor(4 * fraction) * 25;
    const what = phase === 'alignment' ? 'The print finds its place' : 'The seams are made to meet';
    say(`${what}, ${quarter} %`);
  });
  garment.addEventListener('solve', ({detail: {metrics}}) => {
    tellFit(metrics);
  });
  garment.addEventListener('cloth', tellPrice);
  garment.addEventListener('error', ({detail}) => {
    complain(detail);
  });
  // the element's state before this script ran
  if (garment.error) complain(garment.error);
  if (garment.result) {
    tellFit(garment.result.metrics);
    tellPrice();
  }

  problem.querySelector('button').addEventListener('click', () => {
    problem.hidden = true;
    garment.solve().catch(() => undefined); // the event reports it
  });

  /** Shows the drape or the flat pieces; the print is placed on the flat pieces. */
  function show({isFlat, isPlacing}) {
    garment.view = isFlat ? 'pattern' : 'garment';
    garment.mode = isPlacing ? 'place' : 'preview';
    flat.setAttribute('aria-pressed', String(isFlat));
    place.setAttribute('aria-pressed', String(isPlacing));
  }
  flat.addEventListener('click', () => {
    show({isFlat: garment.view !== 'pattern', isPlacing: false});
  });
  place.addEventListener('click', () => {
    const isPlacing = garment.mode !== 'place';
    show({isFlat: isPlacing, isPlacing});
  });

  // pressed early, the button waits for the print and for its price
  form.addEventListener('submit', async (event) => {
    if (garment.value !== '' && garment.clothLengthCm !== null) return;
    event.preventDefault();
    add.setAttribute('aria-disabled', 'true');
    try {
      await garment.layPlan();
      form.requestSubmit(add);
    } catch (error) {
      complain(error);
    } finally {
      add.removeAttribute('aria-disabled');
    }
  });

  if (garment.dataset.design) {
    fetch(garment.dataset.design)
      .then((response) => {
        if (!response.ok) throw new Error('This is not in the cart any more.');
        return response.text();
      })
      .then((design) => garment.setDesign(design))
      .catch(complain);
  }
}
