import { describe, expect, it } from 'vitest';
import { apiIndex, apiPage, apiPages } from './apiPages.mjs';
import { declarationsOf } from './declarations.mjs';
import { parseDocblock } from './docblock.mjs';
import { excerptsOf } from './excerpts.mjs';

const { pages, examples } = apiPages();
const exports = pages.flatMap((page) => page.exports);

it('takes a docblock apart', () => {
  const block = '* Adds a `@lamp`.\n *\n * @param range - reach (m),\n *   above 0\n * @throws Error when it is 0\n ';
  expect(parseDocblock(block)).toEqual({
    text: 'Adds a `@lamp`.',
    params: [{ name: 'range', text: 'reach (m),\n  above 0' }],
    ...{ returns: [], throws: ['Error when it is 0'], see: [], isInternal: false },
  });
  expect(parseDocblock('* Its name. @throws Error when it is empty ')).toMatchObject({
    text: 'Its name.',
    throws: ['Error when it is empty'],
  });
});

describe('a declaration', () => {
  const source = `
    /** A lamp. */
    export class Lamp extends Mesh implements Lit {
      /** Reach (m). */
      readonly range = 20;
      private glow = 1;
      readonly table = { much: 'of it', and: 'more of it', which: 'no reader wants to see' };
      /** @internal */
      hidden = 0;
      constructor(private readonly watts: number, /** Name. */ readonly label: string) { super(); }
      /** Share, 0 to 1. */
      get share(): number { return 1; }
      set share(value: number) {}
      get isLit(): boolean { return true; }
      async fetch(_path: string): Promise<void> {}
    }
    export function add(a: Lamp): void;
    export function add(a: Lamp, b: string): void {}
    /** Half. */
    export const half = (of: number): number => of / 2;
    export const limits = { most: 4 } as const;
    export type Kind = 'point' | 'spot';
  `;
  const found = declarationsOf('lamp.ts', source);

  it('has signatures without bodies, private parts and long values', () => {
    expect(found.get('Lamp')?.signatures).toEqual(['class Lamp extends Mesh implements Lit']);
    expect(found.get('Lamp')?.members.map(({ signature, doc }) => [signature, doc.text])).toEqual([
      ['readonly range = 20', 'Reach (m).'],
      ['readonly table', ''],
      ['constructor(watts: number, label: string)', ''],
      ['readonly label: string', 'Name.'],
      ['share: number', 'Share, 0 to 1.'],
      ['readonly isLit: boolean', ''],
      ['fetch(path: string): Promise<void>', ''],
    ]);
    expect(found.get('add')?.signatures).toEqual([
      'function add(a: Lamp): void',
      'function add(a: Lamp, b: string): void',
    ]);
    expect(found.get('half')).toMatchObject({ kind: 'function', signatures: ['const half = (of: number): number'] });
    expect(found.get('limits')?.signatures).toEqual(['const limits = { most: 4 } as const']);
    expect(found.get('Kind')).toMatchObject({ kind: 'type', signatures: ["type Kind = 'point' | 'spot'"] });
  });
});

it('shows the table of fields that a component extends as members', () => {
  const source =
    "export class Spin extends component({ speed: number(1, { unit: 'rad/s', help: 'Speed of it.' }) }) {}";
  const spin = declarationsOf('Spin.ts', source).get('Spin');
  expect(spin?.signatures).toEqual(['class Spin extends component({ … })']);
  expect(spin?.members).toMatchObject([
    { signature: "speed: number(1, { unit: 'rad/s' })", doc: { text: 'Speed of it.' } },
  ]);
});

describe('an excerpt', () => {
  const source = `
import { expect, it } from 'vitest';
import { Lamp, half, type Kind } from '@farol/lamps';

it('is lit', () => {
  const watts = 40;
  const unused = 1;
  const lamp = new Lamp(watts); // W
  lamp.light();
  expect(half(watts)).toBe(20);
});
const kinds: Kind[] = other;
`;
  const isOurs = ({ specifier }: { specifier: string }) => specifier === '@farol/lamps';
  const excerpts = (isWhole: boolean) =>
    excerptsOf('lamp.test.ts', source, (each) => (isOurs(each) ? each : null), isWhole);

  it('is the statement around a use, with the declarations that it needs and what is done with the thing', () => {
    expect(excerpts(true).get('@farol/lamps Lamp')).toMatchObject({
      code: "import { Lamp } from '@farol/lamps';\nconst watts = 40;\nconst lamp = new Lamp(watts); // W\nlamp.light();",
      line: 8,
      language: 'ts',
    });
  });

  it('shows a check of a test as a value', () => {
    expect(excerpts(true).get('@farol/lamps half')?.code).toBe(
      "import { half } from '@farol/lamps';\nconst watts = 40;\nhalf(watts); // 20",
    );
  });

  it('is left out where it names what it does not show', () => {
    expect(excerpts(true).has('@farol/lamps Kind')).toBe(false);
    expect(excerpts(false).has('@farol/lamps Kind')).toBe(true);
  });
});

describe('pages of the API', () => {
  const texts = new Map(pages.map((page) => [`${page.name}.md`, apiPage(page)]));

  it('show each export of each entry once, under an anchor of its own', () => {
    const anchors = pages.flatMap(({ name, exports }) => exports.map((each) => `${name}#${each.name}`));
    expect(anchors.length).toBeGreaterThan(600);
    expect(new Set(anchors).size).toBe(anchors.length);
    for (const { entry, exports } of pages) for (const { entries } of exports) expect(entries).toContain(entry);
  });

  it('link to what is there', () => {
    const known = new Set(
      pages.flatMap(({ name, exports }) => [name, ...exports.map((each) => `${name}#${each.name}`)]),
    );
    const links = [...texts.values(), apiIndex()].flatMap((text) => [...text.matchAll(/\]\(\.\/([^)]*)\)/g)]);
    expect(links.length).toBeGreaterThan(1000);
    expect(links.map(([, link]) => link.replace('.md', '')).filter((link) => !known.has(link))).toEqual([]);
  });
});

describe('public exports', () => {
  const named = (list: typeof exports) => list.map(({ name, file, line }) => `${name} (${file}:${line})`);

  it('have a docblock each', () => {
    expect(named(exports.filter(({ doc }) => doc.text === ''))).toEqual([]);
  });

  // a class or a type may show the example of what takes or gives it
  it('have an example each, of code that tests compile and run: else add one to e2e/samples', () => {
    expect(named(exports.filter((each) => !examples.has(each)))).toEqual([]);
  });
});
