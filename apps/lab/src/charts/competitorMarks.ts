import { competitorNames } from '../competitors/competitorNames';
import type { MarkSymbolName } from './competitorSymbol';

export interface CompetitorMark {
  /** Colours on a light and on a dark background, with a contrast of at least 3:1. */
  readonly light: string;
  readonly dark: string;
  /** Symbol of the competitor's points; the pair of `symbol` and `hollow` is unique to the competitor. */
  readonly symbol: MarkSymbolName;
  readonly hollow: boolean;
}

const mark = (light: string, dark: string, symbol: MarkSymbolName, hollow = false): CompetitorMark => ({
  ...{ light, dark, symbol, hollow },
});

/** Marks with hand-picked colours: where a colour-blind eye cannot tell two colours apart, the symbols differ. */
const chosen: Readonly<Record<string, CompetitorMark>> = {
  auto: mark('#16181d', '#f4f6fa', 'star'),
  forward: mark('#c8430a', '#ff8149', 'circle'),
  'forward-single-pass': mark('#a06c00', '#eebb45', 'circle', true),
  deferred: mark('#0a5fb5', '#58a6f5', 'square'),
  'light-prepass': mark('#8a3fb0', '#c890e6', 'diamond'),
  inferred: mark('#c92f83', '#f78cc4', 'diamond', true),
  'tiled-deferred': mark('#0b7f9e', '#3fcdec', 'square', true),
  'tiled-forward': mark('#667800', '#bdd33f', 'triangle'),
  'forward-plus': mark('#7a4a1e', '#cf9f70', 'triangle', true),
  'clustered-deferred': mark('#00704f', '#2cc79b', 'hexagon'),
  'clustered-forward': mark('#26922a', '#7ce07c', 'hexagon', true),
  lite: mark('#6b5b00', '#d8c63a', 'star', true),
  stock: mark('#565f6c', '#aab4c2', 'cross'),
  multipass: mark('#80868f', '#858d9a', 'times'),
  'three-webgpu': mark('#4a44c4', '#9d97ff', 'plus'),
  playcanvas: mark('#a3172b', '#ff6f7d', 'wye'),
  babylon: mark('#96657f', '#d6adc4', 'asterisk'),
};

/** Marks given in rotation to techniques that have no hand-picked mark. */
const spare: readonly CompetitorMark[] = [
  mark('#8c5a00', '#e0a850', 'plus', true),
  mark('#00708a', '#55c2dd', 'wye', true),
  mark('#9a4d86', '#e39bd0', 'cross', true),
];

export const competitorMarks: Readonly<Record<string, CompetitorMark>> = {
  ...chosen,
  ...Object.fromEntries(
    Object.keys(competitorNames)
      .filter((name) => !Object.hasOwn(chosen, name))
      .map((name, i) => [name, spare[i % spare.length]]),
  ),
};

const unknown = mark('#565f6c', '#aab4c2', 'plus');

/** The mark of a competitor; a grey one for a competitor that this version does not know. */
export function competitorMark(name: string): CompetitorMark {
  return Object.hasOwn(competitorMarks, name) ? competitorMarks[name] : unknown;
}

/** Index of a competitor in the order of menus and legends; the greatest safe integer for an unknown competitor. */
export function competitorOrder(name: string): number {
  const place = Object.keys(competitorNames).indexOf(name);
  return place === -1 ? Number.MAX_SAFE_INTEGER : place;
}
