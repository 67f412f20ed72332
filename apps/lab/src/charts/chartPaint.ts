import { competitorMark, competitorMarks } from './competitorMarks';

/** Colours of a chart, as CSS values. */
export interface ChartPaint {
  readonly text: string;
  /** Colour of secondary text. */
  readonly dim: string;
  readonly grid: string;
  readonly background: string;
  /** Colour of text over a filled bar or cell. */
  readonly over: string;
  competitor(name: string): string;
  /** Colour of an item of a list, such as a pass of a frame; eight colours, then again from the first. */
  shade(index: number): string;
}

/** Colours for a light and a dark background. */
const colours: Readonly<Record<'text' | 'dim' | 'grid' | 'background' | 'over', readonly [string, string]>> = {
  text: ['#1d2129', '#e3e6ec'],
  dim: ['#565f6c', '#9aa3b2'],
  grid: ['#dfe2e8', '#2c313b'],
  background: ['#ffffff', '#15181d'],
  over: ['#ffffff', '#101216'],
};

/** Line styles (`stroke-dasharray`) by index of the run: solid for the first one, dashed for others. */
export const runDashes: readonly (string | undefined)[] = [undefined, '7 4', '2 4', '10 3 2 3'];

const shades = [
  ['#33629c', '#6ea3e6'],
  ['#b9561f', '#f2a06a'],
  ['#2f7d4e', '#6fcf97'],
  ['#8f4590', '#d596d2'],
  ['#8a700d', '#e2c552'],
  ['#2d7f88', '#6fd0da'],
  ['#8c5a3c', '#cfa184'],
  ['#626873', '#a6adba'],
] as const;

/** Colours of one theme, as literal values, since files have no custom properties. */
export function paintOf(theme: 'light' | 'dark'): ChartPaint {
  const side = theme === 'light' ? 0 : 1;
  return {
    text: colours.text[side],
    dim: colours.dim[side],
    grid: colours.grid[side],
    background: colours.background[side],
    over: colours.over[side],
    competitor: (name) => competitorMark(name)[theme],
    shade: (index) => shades[index % shades.length][side],
  };
}

/** Colours of the page, as custom properties, so that charts follow the theme without being redrawn. */
export const pagePaint: ChartPaint = {
  text: 'var(--chart-text)',
  dim: 'var(--chart-dim)',
  grid: 'var(--chart-grid)',
  background: 'var(--chart-background)',
  over: 'var(--chart-over)',
  competitor: (name) => `var(--competitor-${Object.hasOwn(competitorMarks, name) ? name : 'unknown'})`,
  shade: (index) => `var(--chart-shade-${index % shades.length})`,
};

/** Values of the custom properties in {@link pagePaint}; they follow `color-scheme`. */
export const paintProperties: Readonly<Record<string, string>> = Object.fromEntries([
  ...Object.entries(colours).map(([name, pair]) => [`--chart-${name}`, lightDark(pair)]),
  ...shades.map((pair, i) => [`--chart-shade-${i}`, lightDark(pair)]),
  ...['unknown', ...Object.keys(competitorMarks)].map((name) => {
    const { light, dark } = competitorMark(name);
    return [`--competitor-${name}`, lightDark([light, dark])];
  }),
]);

function lightDark([light, dark]: readonly [string, string]): string {
  return `light-dark(${light}, ${dark})`;
}
