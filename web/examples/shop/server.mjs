// A small shop for clothes whose print matches at the seams. `node server.mjs [--port 8080]
// [--samples FOLDER]`
//
// Every response has the strictest policy that the element supports. There are no cookies, and the
// browser stores nothing: a cart has an address that cannot be guessed, and ends with the server.
import {readFile} from 'node:fs/promises';
import {createServer} from 'node:http';
import {extname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {parseArgs} from 'node:util';

import {FileError, order, SolverError, writeStoredDesign} from 'seamwise/node';

import {Carts} from './carts.mjs';
import {openCatalogue, sizes} from './catalogue.mjs';
import {acceptDesign, priced, Refused} from './designs.mjs';
import {cartPage, messagePage, productPage, shelfPage} from './pages.mjs';
import {Busy, Workshop} from './workshop.mjs';

const policy =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; style-src 'self'; " +
  "img-src 'self'; connect-src 'self'; form-action 'self'";

const types = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
};

/** Limit for a form with one design in it. [bytes] */
const mostOfForm = 1e5;
/** Time limit for the workshop's answer. [ms] */
const patience = 120_000;

const {values} = parseArgs({options: {port: {type: 'string'}, samples: {type: 'string'}}});
const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const samples = values.samples ?? here('../../../public'); // default of the repository
const standalone = fileURLToPath(new URL('.', standaloneUrl()));
const catalogue = await openCatalogue(samples);
const carts = new Carts();
const workshop = new Workshop();

/**
 * Address of the standalone script. Node's own resolution of that entry is another file, without
 * the element.
 */
function standaloneUrl() {
  return new URL('./dist/standalone/seamwise.js', import.meta.resolve('seamwise/package.json'));
}

class HttpError extends Error {
  constructor(status, message) {
    super(message);
    this.status = status;
  }
}

const missing = () => new HttpError(404, 'There is no such page here.');

/**
 * All routes, each with a function from the request and the parts of its path to the response or
 * its promise.
 */
const routes = [
  ['GET', /^\/$/, shelf],
  ['GET', /^\/garment\/([\w-]+)$/, product],
  ['POST', /^\/cart$/, addToCart],
  ['GET', /^\/cart\/([\w-]+)$/, cart],
  ['GET', /^\/cart\/([\w-]+)\/([\w-]+)\/design\.json$/, lineDesign],
  ['GET', /^\/cart\/([\w-]+)\/([\w-]+)\/pieces\.svg$/, linePieces],
  ['POST', /^\/cart\/([\w-]+)\/([\w-]+)\/order$/, orderFile],
  ['POST', /^\/cart\/([\w-]+)\/([\w-]+)\/remove$/, removeLine],
  [
    'GET',
    /^\/(shop\.js|price\.mjs|(?:shop|product|cart)\.css)$/,
    (_, name) => file(here(name), name),
  ],
  ['GET', /^\/seamwise\/([\w.-]+)$/, (_, name) => file(join(standalone, name), name)],
  ['GET', /^(\/(?:garments|prints)\/[\w-]+\.\w+|\/icon\.svg)$/, (_, path) => sample(path)],
];

const page = (body, status = 200) => ({status, type: '.html', body});
const json = (value, headers = {}) => ({status: 200, type: '.json', body: value, headers});
const seeOther = (location) => ({status: 303, type: '.html', body: '', headers: {location}});

async function file(path, name) {
  return {status: 200, type: extname(name), body: await readFile(path)};
}

function sample(path) {
  const found = catalogue.files.get(path);
  if (!found) throw missing();
  return {status: 200, type: extname(path), body: found.bytes};
}

function shelf({query}) {
  const offers = catalogue.garments.map((garment) => ({
    garment,
    print: catalogue.prints.find(({name}) => name === garment.print),
  }));
  return page(shelfPage(offers, cartFor(query.get('cart'))));
}

function product({query}, name) {
  const garment = catalogue.garments.find((one) => one.name === name);
  if (!garment) throw missing();
  const inCart = cartFor(query.get('cart'));
  const lineId = query.get('line');
  const line = lineId === null ? undefined : lineOf(inCart?.id, lineId);
  if (line && line.garment !== garment) throw missing();
  const chosen = line ?? choiceIn(query, garment);
  const shown = {catalogue, garment, chosen, cents: line?.cents};
  return page(productPage({...shown, cart: inCart, lineId: line && lineId}));
}

/** The choice in the address, with defaults for unknown values. */
function choiceIn(query, garment) {
  const named = (list, name, usual) => list.find((one) => one.name === name) ?? usual;
  const {prints} = catalogue;
  const print = named(prints, query.get('print'), named(prints, garment.print));
  return {
    print,
    size: sizes.find((size) => size === query.get('size')) ?? 'm',
    colourway: named(print.colourways, query.get('colourway'), print.colourways[0]),
  };
}

async function addToCart({request, host, signal}) {
  const form = new URLSearchParams(await bodyOf(request));
  const line = acceptDesign(form.get('design') ?? '', catalogue, host);
  const shown = form.get('cents') || undefined;
  const cost = await workshop.run(request.socket.remoteAddress, () =>
    priced(line, shown && Number(shown), catalogue, within(signal)),
  );
  const design = writeStoredDesign(line.design);
  const id = carts.put(form.get('cart'), form.get('line'), {...line, design, ...cost});
  return seeOther(`/cart/${id}`);
}

function cart(_, id) {
  const found = cartFor(id);
  if (!found) throw new HttpError(404, 'This cart is empty, or was given up; choose anew.');
  return page(cartPage(found));
}

function cartFor(id) {
  const lines = id === null ? undefined : carts.lines(id);
  return lines && {id, lines: [...lines].map(([lineId, line]) => ({lineId, ...line}))};
}

function lineOf(id, lineId) {
  const line = carts.lines(id)?.get(lineId);
  if (!line) throw new HttpError(404, 'This is not in the cart any more; choose it anew.');
  return line;
}

function lineDesign(_, id, lineId) {
  return json(lineOf(id, lineId).design);
}

function linePieces(_, id, lineId) {
  return {status: 200, type: '.svg', body: lineOf(id, lineId).thumbnail};
}

/** Ends with the customer's request, or at the time limit. */
const within = (signal) => AbortSignal.any([signal, AbortSignal.timeout(patience)]);

/** The file for the workshop: the design solved again here, from the shop's own files. */
async function orderFile({request, signal}, id, lineId) {
  const {design, garment, size} = lineOf(id, lineId);
  const read = (url) => Promise.resolve(catalogue.files.get(url).bytes);
  const {text} = await workshop.run(request.socket.remoteAddress, () =>
    order(design, {read, signal: within(signal)}),
  );
  const name = `${garment.name}-${size}-${JSON.parse(design).result.slice(0, 8)}.json`;
  return json(text, {'Content-Disposition': `attachment; filename="${name}"`});
}

function removeLine(_, id, lineId) {
  carts.remove(id, lineId);
  return seeOther(`/cart/${id}`);
}

async function bodyOf(request) {
  const parts = [];
  let size = 0;
  for await (const part of request) {
    size += part.length;
    if (size > mostOfForm) throw new HttpError(413, 'That is more than a design needs.');
    parts.push(part);
  }
  return Buffer.concat(parts).toString();
}

async function answer(request, signal) {
  const host = request.headers.host ?? '';
  if (!URL.canParse(request.url, `http://${host}`)) throw missing();
  const {pathname, searchParams} = new URL(request.url, `http://${host}`);
  const method = request.method === 'HEAD' ? 'GET' : request.method;
  for (const [verb, pattern, serve] of routes) {
    const parts = verb === method ? pattern.exec(pathname) : null;
    if (parts) return serve({request, host, signal, query: searchParams}, ...parts.slice(1));
  }
  throw missing();
}

function refusal(error) {
  if (error instanceof Refused) return page(messagePage('We cannot make this', error.message), 400);
  if (error instanceof Busy) return page(messagePage('One moment', error.message), 429);
  if (error instanceof HttpError) {
    return page(messagePage('Not here', error.message), error.status);
  }
  if (error.code === 'ENOENT') return refusal(missing());
  if (error instanceof FileError || error instanceof SolverError) {
    return page(messagePage('The workshop cannot make this', error.message), 422);
  }
  if (error.name !== 'AbortError') console.error(error); // otherwise the customer has left
  return page(messagePage('Our fault', 'Something broke here; please try again.'), 500);
}

const server = createServer((request, response) => {
  const left = new AbortController();
  response.on('close', () => left.abort());
  answer(request, left.signal)
    .catch(refusal)
    .then(({status, type, body, headers}) => {
      response.writeHead(status, {
        'Content-Security-Policy': policy,
        'Content-Type': types[type],
        'X-Content-Type-Options': 'nosniff',
        'Referrer-Policy': 'same-origin', // keeps the cart's address private
        'Cache-Control': type === '.html' ? 'no-store' : 'no-cache',
        ...headers,
      });
      response.end(body);
    });
});

server.listen(Number(values.port ?? 8080), 'localhost', () => {
  console.log(`http://localhost:${server.address().port}/`);
});
