/** What the element is told by attributes, as properties. Three of them may be given as objects, too. */
import {fabricNames, type FabricName} from '../../model/drape.js';
import type {Garment} from '../../model/garment.js';
import type {Print} from '../../model/print.js';
import type {StoredDesign} from '../../model/stored-design.js';
import type {Symmetries, Symmetry} from '../../model/symmetries.js';
import type {WorkerPlaces} from '../../solver/client.js';
import type {Preferences} from '../../texts/preferences.js';
import {
  changeOf,
  clothWidthOf,
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

export abstract class AttributeElement extends FormElement {
  /** What was given as an object, by the name of the attribute in whose place it is. */
  readonly #objects = new Map<string, object>();

  /** URL of the garment's file, or the garment; `{size}` in it stands for the size. Empty: none. */
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

  /** `auto`: what the garment shows by itself; `none`; the URL of a file of symmetries; or these. */
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

  /** One of the print's, by its name; the first where it has no such. */
  get colourway(): string {
    return this.getAttribute('colourway') ?? '';
  }

  set colourway(colourway: string | null | undefined) {
    this.write('colourway', colourway);
  }

  /** No outline moves further than this. [mm] */
  get maxChangeMm(): number {
    return changeOf(this.#read('max-change-mm'));
  }

  set maxChangeMm(most: number) {
    this.write('max-change-mm', String(most));
  }

  get view(): GarmentView {
    return wordOf(this.getAttribute('view'), ['pattern', 'garment', 'both']);
  }

  set view(view: GarmentView | null | undefined) {
    this.write('view', view);
  }

  /** Whether a worn garment hangs on a dummy that is seen. */
  get dummy(): 'shown' | 'hidden' {
    return wordOf(this.getAttribute('dummy'), ['shown', 'hidden']);
  }

  set dummy(dummy: 'shown' | 'hidden' | null | undefined) {
    this.write('dummy', dummy);
  }

  /** What a worn garment is made of. */
  get fabric(): FabricName {
    return wordOf(this.getAttribute('fabric'), fabricNames);
  }

  set fabric(fabric: FabricName | null | undefined) {
    this.write('fabric', fabric);
  }

  /** Where a worn garment is looked at from. */
  get camera(): GarmentCamera {
    return wordOf(this.getAttribute('camera'), ['front', 'back', 'left', 'right', 'three-quarter']);
  }

  set camera(camera: GarmentCamera | null | undefined) {
    this.write('camera', camera);
  }

  /** A worn garment goes round until somebody touches it. */
  get turntable(): boolean {
    return this.hasAttribute('turntable');
  }

  set turntable(turns: boolean) {
    this.toggleAttribute('turntable', turns);
  }

  /** Of cloth on which the answer is laid, between its edges; null: on none. [cm] */
  get clothWidth(): number | null {
    return clothWidthOf(this.#read('cloth-width'));
  }

  set clothWidth(width: number | null | undefined) {
    this.write('cloth-width', width?.toString());
  }

  /** What is of no use along each edge of the cloth. [cm] */
  get selvedge(): number {
    return selvedgeOf(this.getAttribute('selvedge'));
  }

  set selvedge(selvedge: number | null | undefined) {
    this.write('selvedge', selvedge?.toString());
  }

  get mode(): GarmentMode {
    return wordOf(this.getAttribute('mode'), ['preview', 'place', 'edit']);
  }

  set mode(mode: GarmentMode | null | undefined) {
    this.write('mode', mode);
  }

  /** `lazy`: begins when it is scrolled near. */
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

  /** Empty: that of the document around, else the user's. */
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

  /** Something else is asked for. */
  protected abstract ask(): void;

  /** There is an attribute again, in place of an object. */
  protected forget(name: string): void {
    this.#objects.delete(name);
  }

  /** As attributes: a garment's template stays where it gives the same file. */
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

  /** However it is spelled. */
  #read(name: string): string | null {
    return this.getAttribute(name) ?? this.getAttribute(name.replaceAll('-', ''));
  }

  /** Null or undefined: none. */
  protected write(name: string, value: string | null | undefined): void {
    const spelling = name.replaceAll('-', '');
    if (spelling !== name) this.removeAttribute(spelling);
    if (value === null || value === undefined) this.removeAttribute(name);
    else this.setAttribute(name, value);
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

  /** Where the solver is, if the page says so. */
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
