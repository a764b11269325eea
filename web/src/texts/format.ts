/** Formats numbers for people. */
import {formatLength, type Units} from '../model/base/length-text.js';
import type {Language} from './preferences.js';

export interface Format {
  /** A length such as "41 cm" or "16 1/8 in". */
  length(cm: number): string;
  /** A small length such as "1.2 mm" or "0.05 in". */
  fine(cm: number): string;
  /** An area as a number, and the unit of length to be squared. */
  area(cm2: number): {readonly value: string; readonly unit: string};
  /** A share as a percentage, with at least one digit. */
  percent(share: number): string;
  seconds(milliseconds: number): string;
  /** A time of today, or a date. [ms since 1970] */
  moment(time: number): string;
  number(value: number, digits?: number): string;
}

const made = new Map<string, Format>();

export function formatFor(language: Language, units: Units): Format {
  const key = `${language} ${units}`;
  const known = made.get(key);
  if (known) return known;
  const number = (value: number, digits = 1): string =>
    value.toLocaleString(language, {maximumFractionDigits: digits});
  const format: Format = {
    length: (cm) => formatLength(cm, units, language),
    fine: (cm) => formatLength(cm, units, language, {fine: true}),
    area: (cm2) => {
      const value = units === 'inch' ? cm2 / 2.54 ** 2 : cm2;
      return {value: number(value, value < 100 ? 1 : 0), unit: units === 'inch' ? 'in' : 'cm'};
    },
    percent: (share) => {
      const percent = share * 100;
      return `${number(percent, percent < 1 ? 1 : 0)} %`;
    },
    moment: (time) => {
      const date = new Date(time);
      return date.toDateString() === new Date().toDateString()
        ? date.toLocaleTimeString(language, {timeStyle: 'short'})
        : date.toLocaleDateString(language, {dateStyle: 'medium'});
    },
    seconds: (ms) => `${number(ms / 1000, ms < 950 ? 2 : 1)} s`,
    number,
  };
  made.set(key, format);
  return format;
}
