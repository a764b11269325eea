// The shop's pages. Every value in `${}` is escaped text, unless `html` created it.
import {printPath, sizes} from './catalogue.mjs';
import {centsPerMetre, metresFor, money, stepCm} from './price.mjs';

class Html {
  constructor(text) {
    this.text = text;
  }
}

const entities = {'&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;'};

const written = (value) => {
  if (value instanceof Html) return value.text;
  if (Array.isArray(value)) return value.map(written).join('');
  return String(value ?? '').replace(/[&<>"']/g, (sign) => entities[sign]);
};

const html = ({raw}, ...values) => new Html(String.raw({raw}, ...values.map(written)));

const priceRule = `${money(centsPerMetre)} per metre of cloth, cut off the bolt in steps of ${stepCm} cm`;

/** An address of the shop, which keeps the cart. */
const to = (path, cart, more = {}) =>
  `${path}?${new URLSearchParams({...more, ...(cart && {cart: cart.id})})}`.replace(/\?$/, '');

const layout = (title, cart, main, body = '') =>
  html`<!doctype html>
    <html lang="en">
      <head>
        <meta charset="utf-8" />
        <meta name="viewport" content="width=device-width, initial-scale=1" />
        <meta name="color-scheme" content="light dark" />
        <title>${title} – Selvedge</title>
        <link rel="icon" href="/icon.svg" />
        <link rel="stylesheet" href="/shop.css" />
        <link rel="stylesheet" href="/product.css" />
        <link rel="stylesheet" href="/cart.css" />
        <script type="module" src="/seamwise/seamwise.js"></script>
        <script type="module" src="/shop.js"></script>
      </head>
      <body class="${body}">
        <a class="skip" href="#main">Skip to the content</a>
        <header class="top">
          <a class="brand" href="${to('/', cart)}">Selvedge</a>
          <nav aria-label="Shop">
            <a href="${to('/', cart)}">Patterns</a>${
              cart
                ? html`<a href="/cart/${cart.id}">Cart (${cart.lines.length})</a>`
                : html`<span class="quiet">Cart (0)</span>`
            }
          </nav>
        </header>
        <main id="main" tabindex="-1">${main}</main>
        <footer class="foot">
          <p>Printed and cut to order, ready to sew. The print meets at every seam it can.</p>
        </footer>
      </body>
    </html> `.text;

export const messagePage = (title, sentence) =>
  layout(
    title,
    undefined,
    html`<section class="message">
      <h1>${title}</h1>
      <p>${sentence}</p>
      <p><a class="button" href="/">Back to the patterns</a></p>
    </section>`,
  );

export const shelfPage = (offers, cart) =>
  layout(
    'Patterns',
    cart,
    html`<section class="lead">
        <h1>Clothes whose print knows no seams</h1>
        <p>
          Choose a pattern, your size and a print. We shift and shape the pieces by a few
          millimetres, until the flowers go on across the seams, and print and cut the cloth for
          you.
        </p>
      </section>
      <ul class="shelf">
        ${offers.map(
          ({garment, print}) =>
            html`<li class="card">
              <a href="${to(`/garment/${garment.name}`, cart)}">
                <seamwise-garment
                  garment="/garments/${garment.name}-{size}.json"
                  size="m"
                  print="${printPath(print.name)}"
                  alt="${garment.title} in ${print.title}"
                  ><span slot="poster" class="poster">${garment.title}</span></seamwise-garment
                >
                <h2>${garment.title}</h2></a
              >
              <p>${garment.line}</p>
              <p class="quiet">In ${print.title}, ${money(centsPerMetre)} per metre of cloth</p>
            </li>`,
        )}
      </ul>`,
  );

/** @param lineId  of the cart's line that is being changed */
export const productPage = ({catalogue, garment, chosen, cents, cart, lineId}) =>
  layout(
    garment.title,
    cart,
    html`<form id="product" class="product" method="post" action="/cart" autocomplete="off">
      <div class="stage">
        <seamwise-garment
          name="design"
          loading="eager"
          garment="/garments/${garment.name}-{size}.json"
          size="${chosen.size}"
          colourway="${chosen.colourway.name}"
          ${
            lineId
              ? html`data-design="/cart/${cart.id}/${lineId}/design.json"`
              : html`print="${printPath(chosen.print.name)}"`
          }
          cloth-width="${chosen.print.fabric.usableWidthCm}"
          selvedge="0"
          view="garment"
          camera="three-quarter"
          alt="${garment.title} in the print, worn"
          ><p slot="poster" class="poster">
            ${garment.title} in ${chosen.print.title}
          </p></seamwise-garment
        >
        <div class="under">
          <p id="progress" role="status">The print is being laid on the pieces …</p>
          <button type="button" id="flat" aria-pressed="false">Show the pieces</button>
          <button type="button" id="place" aria-pressed="false">Place the print yourself</button>
        </div>
        <div id="problem" class="problem" role="alert" hidden>
          <p></p>
          <button type="button">Try again</button>
        </div>
      </div>
      <div class="choice">
        <h1>${garment.title}</h1>
        <p>${garment.line}</p>
        <fieldset class="sizes">
          <legend>Size</legend>
          ${sizes.map(
            (size) =>
              html`<label
                ><input
                  type="radio"
                  name="size"
                  value="${size}"
                  ${size === chosen.size ? html`checked` : ''}
                /><span>${size.toUpperCase()}</span></label
              >`,
          )}
        </fieldset>
        <fieldset class="prints">
          <legend>Print</legend>
          ${catalogue.prints.map((print) =>
            swatch('print', print.name, print.title, print.colourways[0], print === chosen.print),
          )}
        </fieldset>
        ${catalogue.prints.map(
          (print) =>
            html`<fieldset
              class="colours"
              data-print="${print.name}"
              data-width="${print.fabric.usableWidthCm}"
              ${print === chosen.print ? '' : html`hidden`}
            >
              <legend>Colour</legend>
              ${print.colourways.map((worn, k) =>
                swatch(
                  `colourway-${print.name}`,
                  worn.name,
                  worn.name,
                  worn,
                  print === chosen.print ? worn === chosen.colourway : k === 0,
                ),
              )}
            </fieldset>`,
        )}
        <section class="price" aria-label="Price" aria-live="polite">
          <p><strong id="price">${cents === undefined ? '…' : money(cents)}</strong></p>
          <p class="quiet" id="length">Its pieces are being laid on the cloth.</p>
          <p class="quiet">${priceRule}.</p>
        </section>
        <input type="hidden" name="cents" />
        <input type="hidden" name="cart" value="${cart?.id}" /><input
          type="hidden"
          name="line"
          value="${lineId}"
        />
        <button class="button" id="add">${lineId ? 'Keep the changes' : 'Add to cart'}</button>
        <noscript
          ><p class="problem">
            This page needs JavaScript to lay the print on the pieces.
          </p></noscript
        >
      </div>
    </form>`,
    'wide',
  );

const swatch = (field, value, title, {raster}, isChosen) =>
  html`<label class="swatch"
    ><input type="radio" name="${field}" value="${value}" ${isChosen ? html`checked` : ''} /><img
      src="/prints/${raster}"
      alt=""
      width="96"
      height="96"
    /><span>${title}</span></label
  >`;

export function cartPage(cart) {
  const total = cart.lines.reduce((sum, {cents}) => sum + cents, 0);
  const lines = cart.lines.map((line) => {
    const {lineId, garment, size, print, colourway, lengthCm, cents, visibleSeams} = line;
    const at = `/cart/${cart.id}/${lineId}`;
    const what = `${garment.title}, ${size.toUpperCase()}`;
    return html`<li class="line">
      <img class="pieces" src="${at}/pieces.svg" alt="Its pieces in the print" />
      <div class="what">
        <h2><a href="${to(`/garment/${garment.name}`, cart, {line: lineId})}">${what}</a></h2>
        <p class="quiet">
          ${print.title}, ${colourway.name}, ${metresFor(lengthCm).toFixed(2)} m of cloth
        </p>
        <p class="quiet">
          The print meets at ${visibleSeams.matched} of ${visibleSeams.of} visible seams.
        </p>
      </div>
      <p class="cost">${money(cents)}</p>
      <div class="deeds">
        <form method="post" action="${at}/order">
          <button>Order file for the workshop<span class="hidden">: ${what}</span></button>
        </form>
        <a href="${at}/design.json" download="design.json"
          >Design<span class="hidden">: ${what}</span></a
        >
        <form method="post" action="${at}/remove">
          <button class="plain">Remove<span class="hidden">: ${what}</span></button>
        </form>
      </div>
    </li>`;
  });
  const filled = html`<ul class="lines">
      ${lines}
    </ul>
    <p class="total"><span>Total</span> <strong>${money(total)}</strong></p>
    <p class="quiet">${priceRule}. This address is your cart: keep it to come back.</p>`;
  const empty = html`<p>Nothing in it yet.</p>`;
  return layout(
    'Cart',
    cart,
    html`<section class="cart">
      <h1>Your cart</h1>
      ${cart.lines.length > 0 ? filled : empty}
      <p><a class="button second" href="${to('/', cart)}">Go on choosing</a></p>
    </section>`,
  );
}
