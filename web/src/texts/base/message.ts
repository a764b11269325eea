/**
 * Texts with placeholders, in a part of the ICU message format: `{name}` for a string,
 * `{name, number}` for a whole number, `{name, plural, one {# seam} other {# seams}}` and
 * `{name, selectordinal, one {#st} other {#th}}`. A form is a category of `Intl.PluralRules`, or
 * exact, like `=1`. A form of a translation may contain placeholders.
 */

/** Names of the placeholders of a text, in order. */
type Names<Text extends string, Seen = never> = Text extends `${string}{${infer Head}}${infer Rest}`
  ? Head extends `${infer Name}, plural,${string}` | `${infer Name}, selectordinal,${string}`
    ? Next<Name, Rest extends `${string}}}${infer Tail}` ? Tail : '', Seen>
    : Next<Head extends `${infer Name}, number` ? Name : Head, Rest, Seen>
  : [];
type Next<Name extends string, Rest extends string, Seen> = Name extends Seen
  ? Names<Rest, Seen>
  : [Name, ...Names<Rest, Name | Seen>];

/** A placeholder with a format is a number. */
type Value<Text extends string, Name extends string> = Text extends `${string}{${Name},${string}`
  ? number
  : string;

/** A function from the values of the placeholders, in their order, to the text. */
type Message<Text extends string, Order extends readonly string[] = Names<Text>> = (
  ...values: {[Index in keyof Order]: Value<Text, Order[Index]>}
) => string;

/** Properties of the functions made by `text`. */
export interface Source {
  readonly text: string;
  /** Names of the placeholders, in the order of the function's parameters. */
  readonly names: readonly string[];
}

/** The value of a placeholder, by its name. */
type ValueOf = (name: string) => string | number | undefined;

/** Name, kind and forms of a placeholder. A form may contain placeholders without forms. */
const placeholder = /\{(\w+)(?:, (\w+)(,(?: \S+ \{(?:[^{}]|\{.*?\})*\})+)?)?\}/g;

/**
 * A text with values in place of its placeholders.
 * @param language language of plural forms
 */
export const formatted = (text: string, valueOf: ValueOf, language = 'en'): string =>
  text.replace(placeholder, (_, name: string, kind: string, forms?: string) => {
    const value = String(valueOf(name));
    if (!forms) return value;
    const form = (key: string): string | undefined =>
      new RegExp(` ${key} \\{((?:[^{}]|\\{.*?\\})*)\\}`).exec(forms)?.[1];
    const type = kind === 'plural' ? 'cardinal' : 'ordinal';
    const category = new Intl.PluralRules(language, {type}).select(+value);
    const chosen = form(`=${value}`) ?? form(category) ?? form('other') ?? '';
    return formatted(chosen.replaceAll('#', value), valueOf, language);
  });

const message = (text: string, names: readonly string[], language?: string) =>
  Object.assign(
    (...given: readonly (string | number)[]): string =>
      formatted(text, (name) => given[names.indexOf(name)], language),
    {text, names} satisfies Source,
  );

/**
 * An English text with placeholders.
 * @param order names of the parameters, if they differ from the order of the placeholders
 */
export function text<Text extends string>(english: Text): Message<Text>;
export function text<Text extends string, Order extends readonly string[]>(
  english: Text,
  ...order: Order
): Message<Text, Order>;
export function text(english: string, ...order: readonly string[]) {
  const names = new Set(order.length > 0 ? order : english.match(/(?<=\{)\w+(?=[,}])/g));
  return message(english, [...names]);
}

/** A translation of texts: strings in place of functions. */
export type Translation<Texts> = Texts extends string | ((...given: never) => string)
  ? string
  : Texts extends readonly unknown[]
    ? readonly unknown[]
    : {readonly [Name in keyof Texts]: Translation<Texts[Name]>};

/** The texts of a translation, with the types of the English ones. */
export const translated = <Texts>(
  english: Texts,
  translation: Translation<Texts>,
  language: string,
): Texts => translatedAs(english, translation, language) as Texts;

type Loaders<Texts> = Readonly<
  Record<string, () => Promise<{readonly default: Translation<Texts>}>>
>;

/**
 * Loads the texts of a language; English has no loader.
 * @throws {Error} without network
 */
export async function loadTranslated<Texts>(
  english: Texts,
  loaders: Loaders<Texts>,
  language: string,
): Promise<Texts> {
  const load = loaders[language];
  return load ? translated(english, (await load()).default, language) : english;
}

function translatedAs(english: unknown, own: unknown, language: string): unknown {
  if (typeof english === 'function' && typeof own === 'string') {
    return message(own, (english as Partial<Source>).names ?? [], language);
  }
  if (typeof own !== 'object' || own === null || Array.isArray(own)) return own;
  return Object.fromEntries(
    Object.entries(own).map(([name, one]) => [
      name,
      translatedAs(Reflect.get(english as object, name), one, language),
    ]),
  );
}
