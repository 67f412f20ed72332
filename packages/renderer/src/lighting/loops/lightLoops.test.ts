import { describe, expect, it } from 'vitest';
import { lightLoops } from '../../materials/LightLoop';
import page from './README.md?raw';

const files = import.meta.glob<string>(
  ['../../**/*.{glsl,ts}', '!../../**/*.{test,bench}.ts', '!../../{effects,adapters,authoring}/**'],
  { query: '?raw', import: 'default', eager: true },
);

/** Texts by path from `src/`. */
const sources = Object.fromEntries(
  Object.entries(files).map(([path, text]) => [new URL(path, 'file:///lighting/loops/').pathname, text]),
);

interface Sharing {
  readonly defined: string[];
  readonly used: string[];
}

/** Macros that a file of lighting, light lists and volumes or the G-buffer shares with another: names of the files, in alphabetical order. */
function sharedMacros(texts: Record<string, string>): Record<string, Sharing> {
  const macros = new Map<string, { defined: Set<string>; used: Set<string> }>();
  const of = (name: string) => {
    const macro = macros.get(name) ?? { defined: new Set<string>(), used: new Set<string>() };
    macros.set(name, macro);
    return macro;
  };
  for (const [path, text] of Object.entries(texts)) {
    const code = text.replace(/\/\*[^]*?\*\/|\/\/.*/g, '');
    const definition = /#define (FAROL_\w+)|\b(FAROL_\w+): /g;
    for (const [, macro, option] of code.matchAll(definition)) of(macro ?? option).defined.add(path);
    for (const [name] of code.replace(definition, '').matchAll(/\bFAROL_\w+/g)) of(name).used.add(path);
  }
  const shared = [...macros].filter(([, { defined, used }]) => {
    const all = new Set([...defined, ...used]);
    return (
      defined.size > 0 &&
      all.size > 1 &&
      [...all].some((path) =>
        /^\/(lighting\/(?!area-lights\/(?!areaLight\.glsl))|gbuffer\/|techniques\/light-(lists|volumes)\/)/.test(path),
      )
    );
  });
  const names = (paths: Set<string>) => [...paths].map((path) => path.slice(path.lastIndexOf('/') + 1)).toSorted();
  return Object.fromEntries(
    shared.map(([name, { defined, used }]) => [name, { defined: names(defined), used: names(used) }]),
  );
}

/** The macros of the page's list. */
function rowsOf(text: string): Record<string, Sharing> {
  const list = (names: string) => names.split(', ').filter((name) => name !== '');
  return Object.fromEntries(
    [...text.matchAll(/^- `(FAROL_\w+)` \((.*) → (.*)\): \S/gm)].map(([, name, defined, used]) => [
      name,
      { defined: list(defined), used: list(used) },
    ]),
  );
}

describe('the page about light loops', () => {
  it('names each macro that is shared, who defines it and who uses it', () => {
    expect(Object.keys(sources).length).toBeGreaterThan(200);
    expect(rowsOf(page)).toEqual(sharedMacros(sources));
  });

  it('names no macro that does not exist', () => {
    const named = new Set([...page.matchAll(/FAROL_\w+/g)].map(([name]) => name));
    const code = Object.values(sources).join('\n');
    expect([...named].filter((name) => !new RegExp(`\\b${name}\\b`).test(code))).toEqual([]);
  });

  it('names each loop, and says truly which gives the sums', () => {
    const rows = [...page.matchAll(/^- `(lightLoop\w+)`, ([^.]*)\./gm)];
    expect(rows.map(([, name]) => name)).toEqual(Object.keys(lightLoops));
    for (const [, name, gives] of rows) {
      const [text] = Object.entries(sources).flatMap(([path, source]) =>
        path.endsWith(`/${name}.glsl`) ? source : [],
      );
      expect(text).toContain('#define FAROL_FOR_EACH_LIGHT(positionVS)');
      expect(text.includes('void farol_addAll(inout FarolShading s)'), name).toBe(gives.includes('farol_addAll'));
    }
  });

  it('is held by what the sources share', () => {
    const shared = {
      '/lighting/a.glsl': '#define FAROL_A 1\n#define FAROL_OWN 1 // FAROL_B\nfloat a = FAROL_OWN;',
      '/shadows/b.ts': 'const define = { FAROL_D: "" }; // FAROL_A\n`FAROL_A`',
      '/lighting/c.glsl': '#ifdef FAROL_D\n#endif',
      '/shadows/d.glsl': '#define FAROL_E',
      '/shadows/e.glsl': 'FAROL_E',
    };
    expect(sharedMacros(shared)).toEqual({
      FAROL_A: { defined: ['a.glsl'], used: ['b.ts'] },
      FAROL_D: { defined: ['b.ts'], used: ['c.glsl'] },
    });
  });
});
