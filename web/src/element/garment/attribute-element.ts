/** Attributes of the element as properties. Three of them also accept objects. */
import {fabricNames, type FabricName} from '../../model/result/draped-garment.js';
import type {Garment} from '../../model/garment/specification.js';
import type {Print} from '../../model/print/repeating-print.js';
import type {StoredDesign} from '../../model/documents/stored-design.js';
import type {Symmetries, Symmetry} from '../../model/garment/symmetries.js';
import type {WorkerPlaces} from '../../solver/page-solvers.js';
import type {Preferences} from '../../texts/preferences.js';
import {
  attributes,
  changeOf,
  clothWidthOf,
  printSizesOf,
  selvedgeOf,
  unitsOf,
  wordOf,
  type GarmentCamera,
  type GarmentLoading,
  type GarmentMode,
  type GarmentView,
} from './attributes.js';
import {FormElement} from './form-element.js';
import {garmentUrl, type Asked} from './sources.js';

/** Properties that a page may have set before the element was defined. */
const properties = [
  ...attributes.map((name) =>
    name.replaceAll(/-(.)/g, (_, letter: string) => letter.toUpperCase()),
  ),
  ...['messages', 'prints', 'value'],
];

/**
 * Passes properties that were set before the definition to the element's setters, which they would
 * hide otherwise.
 */
export function upgrade(element: HTMLElement): void {
  for (const name of properties) {
    if (!Object.hasOwn(element, name)) continue;
    const value: unknown = Reflect.get(element, name);
    Reflect.deleteProperty(element, name);
    Reflect.set(element, name, value);
  }
}

export abstract class AttributeElement extends FormElement {
  /** Values given as objects, by the name of the attribute that they replace. */
  readonly #objects = new Map<string, object>();

  /**
   * URL of the garment's file, or the garment; `{size}` in it is replaced by the size. Empty: none.
   */
  get garment(): string | Garment {
    return this.#given('garment') as string | Garment;
  }

  set garment(garment: string | Garment | null | undefined) {
    this.#give('garment', garment);
  }

  /** URL of the print's file, or the print. Empty: none. */
  get print(): string | Print {
    return this.#given('print') as string | Print;
  }

  set print(print: string | Print | null | undefined) {
    this.#give('print', print);
  }

  /**
   * `auto`: symmetries detected in the garment; `none`; the URL of a file of symmetries; or an
   * object.
   */
  get symmetry(): string | Symmetries | readonly Symmetry[] {
    const given = this.#given('symmetry');
    return given === '' ? 'auto' : (given as string | Symmetries | readonly Symmetry[]);
  }

  set symmetry(symmetry: string | Symmetries | readonly Symmetry[] | null | undefined) {
    this.#give('symmetry', symmetry);
  }

  get size(): string {
    return this.getAttribute('size') ?? '';
  }

  set size(size: string | null | undefined) {
    this.write('size', size);
  }

  /** Name of one of the print's colourways; unknown names select the first. */
  get colourway(): string {
    return this.getAttribute('colourway') ?? '';
  }

  set colourway(colourway: string | null | undefined) {
    this.write('colourway', colourway);
  }

  /**
   * Sizes in which the shop prints the fabric, as multiples of the print's own size. The editor
   * compares them. Empty: the fabric has one size.
   */
  get printSizes(): readonly number[] {
    return printSizesOf(this.#read('print-sizes'));
  }

  set printSizes(sizes: readonly number[] | null | undefined) {
    const list: unknown = sizes;
    const isList = Array.isArray(list);
    this.write('print-sizes', isList ? list.filter(Number.isFinite).join(' ') : list);
  }

  /** Greatest movement of an outline. [mm] */
  get maxChangeMm(): number {
    return changeOf(this.#read('max-change-mm'));
  }

  set maxChangeMm(most: number) {
    this.write('max-change-mm', most);
  }

  get view(): GarmentView {
    return wordOf(this.getAttribute('view'), ['pattern', 'garment', 'both']);
  }

  set view(view: GarmentView | null | undefined) {
    this.write('view', view);
  }

  /** Visibility of the dummy under a drape. */
  get dummy(): 'shown' | 'hidden' {
    return wordOf(this.getAttribute('dummy'), ['shown', 'hidden']);
  }

  set dummy(dummy: 'shown' | 'hidden' | null | undefined) {
    this.write('dummy', dummy);
  }

  /** Fabric of a drape. */
  get fabric(): FabricName {
    return wordOf(this.getAttribute('fabric'), fabricNames);
  }

  set fabric(fabric: FabricName | null | undefined) {
    this.write('fabric', fabric);
  }

  /** View direction of a drape. */
  get camera(): GarmentCamera {
    return wordOf(this.getAttribute('camera'), ['front', 'back', 'left', 'right', 'three-quarter']);
  }

  set camera(camera: GarmentCamera | null | undefined) {
    this.write('camera', camera);
  }

  /** The drape rotates until the user touches it. */
  get turntable(): boolean {
    return this.hasAttribute('turntable');
  }

  set turntable(turns: boolean) {
    this.toggleAttribute('turntable', turns);
  }

  /** Usable fabric width between the edges for the layout; null: no layout. [cm] */
  get clothWidth(): number | null {
    return clothWidthOf(this.#read('cloth-width'));
  }

  set clothWidth(width: number | null | undefined) {
    this.write('cloth-width', width);
  }

  /** Unusable strip along each edge of the fabric. [cm] */
  get selvedge(): number {
    return selvedgeOf(this.getAttribute('selvedge'));
  }

  set selvedge(selvedge: number | null | undefined) {
    this.write('selvedge', selvedge);
  }

  get mode(): GarmentMode {
    return wordOf(this.getAttribute('mode'), ['preview', 'place', 'edit']);
  }

  set mode(mode: GarmentMode | null | undefined) {
    this.write('mode', mode);
  }

  /** `lazy`: starts when it is near the visible part of the page. */
  get loading(): GarmentLoading {
    return wordOf(this.getAttribute('loading'), ['lazy', 'eager']);
  }

  set loading(loading: GarmentLoading | null | undefined) {
    this.write('loading', loading);
  }

  get units(): Preferences['units'] {
    return unitsOf(this.getAttribute('units'));
  }

  set units(units: Preferences['units'] | null | undefined) {
    this.write('units', units);
  }

  /** Empty: the language of the surrounding document, or else the user's. */
  get locale(): string {
    return this.getAttribute('locale') ?? '';
  }

  set locale(locale: string | null | undefined) {
    this.write('locale', locale);
  }

  get alt(): string {
    return this.getAttribute('alt') ?? '';
  }

  set alt(alt: string | null | undefined) {
    this.write('alt', alt);
  }

  get workerUrl(): string {
    return this.#read('worker-url') ?? '';
  }

  set workerUrl(url: string | null | undefined) {
    this.write('worker-url', url);
  }

  get wasmUrl(): string {
    return this.#read('wasm-url') ?? '';
  }

  set wasmUrl(url: string | null | undefined) {
    this.write('wasm-url', url);
  }

  /** The request has changed. */
  protected abstract ask(): void;

  /** Drops an object whose attribute is set again. */
  protected forget(name: string): void {
    this.#objects.delete(name);
  }

  /** Writes a design to the attributes; keeps the garment's template if it gives the same file. */
  protected writeDesign({garment, print, symmetry, options, fabric}: StoredDesign): void {
    const template = this.getAttribute('garment');
    const isThis = template !== null && sameUrl(garmentUrl(template, garment.size), garment.url);
    if (isThis) this.forget('garment');
    else this.garment = garment.url;
    this.write('size', garment.size);
    this.print = print.url;
    this.colourway = print.colourway;
    this.symmetry = symmetry;
    this.fabric = fabric;
    if (options.maxChangeCm !== undefined) this.maxChangeMm = options.maxChangeCm * 10;
  }

  #given(name: 'garment' | 'print' | 'symmetry'): string | object {
    return this.#objects.get(name) ?? this.getAttribute(name) ?? '';
  }

  #give(name: 'garment' | 'print' | 'symmetry', value: string | object | null | undefined): void {
    if (value === null || typeof value !== 'object') {
      const had = this.#objects.delete(name);
      this.write(name, value);
      if (had) this.ask();
      return;
    }
    this.removeAttribute(name);
    this.#objects.set(name, value);
    this.ask();
  }

  /** Reads an attribute in either spelling. */
  #read(name: string): string | null {
    return this.getAttribute(name) ?? this.getAttribute(name.replaceAll('-', ''));
  }

  protected get isAskable(): boolean {
    return this.#given('garment') !== '' && this.#given('print') !== '';
  }

  protected get asked(): Asked {
    const {size, colourway} = this;
    return {
      garment: this.#given('garment') || undefined,
      print: this.#given('print') || undefined,
      symmetry: this.symmetry,
      size: size || undefined,
      colourway: colourway || undefined,
      maxChangeCm: this.maxChangeMm / 10,
      fabric: this.fabric,
    };
  }

  /** URLs of the solver, if the page sets them. */
  protected get solverPlaces(): WorkerPlaces {
    const {workerUrl, wasmUrl} = this;
    const isPlace = (url: string): boolean => url !== '' && URL.canParse(url, document.baseURI);
    const at = (url: string): string => new URL(url, document.baseURI).href;
    return {
      ...(isPlace(workerUrl) && {workerUrl: at(workerUrl)}),
      ...(isPlace(wasmUrl) && {wasmUrl: at(wasmUrl)}),
    };
  }
}

const sameUrl = (one: string, other: string): boolean =>
  URL.canParse(one, document.baseURI) &&
  URL.canParse(other, document.baseURI) &&
  new URL(one, document.baseURI).href === new URL(other, document.baseURI).href;
