/** The angles that grain allows a piece. */
import {describe, expect, it} from 'vitest';

import type {Design} from '@/model/design/design.js';
import {bareFabric} from '@/workbench/samples.js';
import {angleAfter, grainRule} from '@/model/design/grain-rule.js';
import {isAllowed} from '@/model/print/mirror-lines.js';

const degrees = (angle: number): number => (angle * Math.PI) / 180;
type Grain = Design['options']['grain'];
const ruleOf = (
  grain: Grain,
  more: Partial<Design['print']> = {},
  line?: Parameters<typeof grainRule>[2],
): ReturnType<typeof grainRule> =>
  grainRule({print: {...bareFabric, ...more}, options: {...(grain && {grain})}}, 'front', line);
const allows = (rule: ReturnType<typeof grainRule>, ...some: readonly number[]): boolean[] =>
  some.map((angle) => isAllowed(degrees(angle), rule));

describe('a piece', () => {
  it('may lie at any angle unless something is said', () => {
    expect(ruleOf(undefined)).toBeUndefined();
    expect(ruleOf({default: 'on', pieces: {front: 'free'}})).toBeUndefined();
  });

  it('lies on grain either way up, but one way up on a print that has an upside', () => {
    expect(allows(ruleOf({default: 'on'}), 0, 180, 90, 1)).toEqual([true, true, false, false]);
    expect(allows(ruleOf({default: 'on'}, {oneWay: true}), 0, 180)).toEqual([true, false]);
  });

  it('follows its own grain line, its own rule and its own tolerance', () => {
    const level = [
      [0, 0],
      [5, 0],
    ] as const;
    expect(allows(ruleOf({default: 'on'}, {}, level), -90, 0)).toEqual([true, false]);
    const own = {default: 'on', pieces: {front: {lock: 'bias', toleranceDeg: 5}}} as const;
    expect(allows(ruleOf(own), 45, -45, 49, 0)).toEqual([true, true, true, false]);
  });
});

describe('a turn', () => {
  it('is by degrees where any angle is allowed, and within a tolerance', () => {
    expect(angleAfter(undefined, 0.2, 1)).toBeCloseTo(0.2 + degrees(1), 12);
    const near = ruleOf({default: 'on', toleranceDeg: 3});
    expect(angleAfter(near, 0, 1)).toBeCloseTo(degrees(1), 12);
  });

  it('goes on to the next angle of the grain, in its own sense', () => {
    const bias = ruleOf({default: 'bias'});
    expect(angleAfter(bias, degrees(45), 1)).toBeCloseTo(degrees(135), 9);
    expect(angleAfter(bias, degrees(45), -1)).toBeCloseTo(degrees(-45), 9);
    const straight = ruleOf({default: 'on'}, {oneWay: true});
    expect(Math.sin(angleAfter(straight, 0, 1) / 2)).toBeCloseTo(0, 9);
  });
});

describe('a piece on the print', () => {
  it('lies across either way, whatever the print, and where its grain line was said to run', () => {
    const across = {pieces: {front: 'across'}} as const;
    for (const oneWay of [false, true])
      expect(allows(ruleOf(across, {oneWay}), 90, -90, 0)).toEqual([true, true, false]);
    const said = {default: 'on', pieces: {front: {angleDeg: 30}}} as const;
    expect(allows(ruleOf(said), -60, 120, 0)).toEqual([true, true, false]);
  });

  it('stays within 60 degrees of upright on a print that has an upside, though its grain is free', () => {
    expect(allows(ruleOf(undefined, {oneWay: true}), 59, -59, 61, 165)).toEqual([
      ...[true, true, false, false],
    ]);
  });
});
