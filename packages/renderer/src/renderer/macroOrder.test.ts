import { MeshStandardMaterial, MeshToonMaterial } from 'three';
import { expect, it } from 'vitest';
import type { Lazy } from '../frame/Lazy';
import { lightLoops, type LightLoop } from '../materials/LightLoop';
import { litTwin } from '../materials/litTwin';
import { MicroShaderRegistry, parseMicroShader } from '../microshaders';
import { coreSources } from './coreSources';
import { lazyCode } from './lazyCode';

const files = import.meta.glob<string>('../**/*.glsl', { query: '?raw', import: 'default', eager: true });
const lazy: readonly { readonly microShaders?: Readonly<Record<string, string>> }[] = await Promise.all(
  (lazyCode as readonly Lazy<object>[]).map((part) => part.load()),
);
/** Texts of the microshaders, by name: from files, and generated from tables. */
const chunks: Readonly<Record<string, string>> = Object.assign(
  Object.fromEntries(
    Object.entries(files).map(([path, text]) => [path.slice(path.lastIndexOf('/') + 1, -'.glsl'.length), text]),
  ),
  coreSources,
  ...lazy.map(({ microShaders }) => microShaders),
);
const sources = import.meta.glob<string>(['../**/*.ts', '!../**/*.{test,bench}.ts'], {
  query: '?raw',
  import: 'default',
  eager: true,
});

const LISTED = ['lightLoopTiled', 'lightLoopClustered', 'lightLoopSlices'];
/** Microshaders for variables in the lists of passes. */
const variables: Readonly<Record<string, readonly string[]>> = {
  'lists.loop': LISTED,
  'this.target': ['volumeLighting', 'volumeLightBuffer'],
  loop: LISTED,
  chunk: [],
};
/** Microshaders that replace others once a scene has shadows, light layers or area lights. */
const swaps: readonly Readonly<Record<string, string>>[] = [
  {},
  { lightMask: 'lightMaskOn', areaLight: 'areaLightOn' },
  { lightMask: 'lightMaskLayers', areaLight: 'areaLightOn' },
];
/** Lists of microshaders in the sources, at a property of that name, each of its variables replaced. */
function listsIn(property: string): string[][] {
  const found = Object.values(sources).flatMap((text) => [
    ...text.matchAll(new RegExp(`\\b${property}: \\[([\\w.', ]+)\\]`, 'g')),
  ]);
  return found.flatMap(([, list]) => {
    let lists: string[][] = [[]];
    for (const each of list.split(',').map((name) => name.trim())) {
      const names = each.startsWith("'") ? [each.slice(1, -1)] : variables[each];
      if (names === undefined)
        throw new Error(`${each} in [${list}] is no name: add it to the variables of this test.`);
      lists = lists.flatMap((before) => names.map((name) => [...before, name]));
    }
    return lists;
  });
}

/** Lists of microshaders of lit materials' twins: each loop, with the chunks that kinds of twins add. */
function twinLists(): string[][] {
  const own = new MeshStandardMaterial();
  own.onBeforeCompile = () => {};
  const materials = [new MeshStandardMaterial(), new MeshToonMaterial(), own];
  const additions = [[], ...listsIn('chunks')];
  return (Object.keys(lightLoops) as LightLoop[]).flatMap((loop) =>
    additions.flatMap((added) =>
      [false, true].flatMap((oneByOne) => {
        const kind = litTwin({ key: 'test', loop, oneByOne, chunks: added });
        return materials.map((material) => [...kind.chunks(material)]);
      }),
    ),
  );
}

/** Names of the macros that a shader's text redefines or undefines after code that expands them. */
function redefined(text: string): string[] {
  const code = text.replace(/\/\*[^]*?\*\/|\/\/.*/g, '').replaceAll('\\\n', ' ');
  const bodies = new Map<string, string>();
  const used = new Set<string>();
  const faults = new Set<string>();
  const use = (words: string): void => {
    for (const [name] of words.matchAll(/\b[A-Za-z_]\w*/g)) {
      const body = bodies.get(name);
      if (body === undefined || used.has(name)) continue;
      used.add(name);
      use(body);
    }
  };
  for (const line of code.split('\n')) {
    const directive = /^\s*#\s*(\w+)\s*(\w*)(\([^)]*\))?(.*)/.exec(line);
    if (directive === null) use(line);
    if (directive?.[1] !== 'define' && directive?.[1] !== 'undef') continue;
    const [, kind, name, , body] = directive;
    if (used.has(name)) faults.add(name);
    used.delete(name);
    if (kind === 'define') bodies.set(name, `${bodies.get(name) ?? ''} ${body}`);
    else bodies.delete(name);
  }
  return [...faults];
}

it('tells a macro that is defined anew after code that expands it, itself or by another macro', () => {
  const code = 'int f() { return B; }\n';
  expect(redefined(`#define A 1\n#define B A\n${code}#undef A\n#define A 2\n`)).toEqual(['A']);
  expect(redefined(`#define A 1\n#define B A\n#undef A\n#define A 2\n${code}`)).toEqual([]);
  expect(redefined(`#define B(x) \\\n  A(x)\n#define A(x) 1\n// B\n#define A(x) 2\n${code}#define B 3`)).toEqual(['B']);
});

it('no shader that is composed of microshaders defines a macro anew after code that expands it: that code would keep the first', () => {
  const lists = [...Object.keys(chunks).map((name) => [name]), ...listsIn('fragment'), ...twinLists()];
  expect(lists.length).toBeGreaterThan(300);
  const faults = new Set<string>();
  for (const swapped of swaps) {
    const registry = new MicroShaderRegistry();
    for (const [name, text] of Object.entries(chunks))
      registry.add(parseMicroShader(name, chunks[swapped[name]] ?? text));
    for (const list of lists)
      for (const macro of redefined(registry.header(list))) faults.add(`${macro}: ${list.join(', ')}`);
  }
  expect([...faults]).toEqual([]);
});
