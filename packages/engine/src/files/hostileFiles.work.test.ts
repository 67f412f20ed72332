import { workOf } from '@farol/tools/workOf';
import { describe, expect, test } from 'vitest';
import { Scene } from '../core/Scene';
import type { Prefab } from '../core/Prefab';
import { changePrefab } from '../prefabs/planPrefabChange';
import { deserialize } from './deserialize';
import type { FarolFile, FileObject } from './FarolFile';
import { FileError } from '../guard/FileError';
import { parseFile } from './parseFile';
import { serialize } from './serialize';

const sceneOf = (objects: FileObject[], prefabs?: Prefab[]): FarolFile => ({
  format: 'farol-scene',
  version: 2,
  name: 'Hostile',
  settings: {},
  activeCamera: null,
  assets: [],
  ...(prefabs ? { prefabs } : {}),
  objects,
});

const object = (id: string, parent: string | null = null, prefab?: string): FileObject => ({
  id,
  name: id,
  parent,
  ...(prefab === undefined ? {} : { prefab: { prefab, source: prefab } }),
  components: [],
});

/** A chain of `count` objects, each the child of the previous one. */
const chain = (count: number): FileObject[] =>
  Array.from({ length: count }, (_, i) => object(`o${i}`, i === 0 ? null : `o${i - 1}`));

/** Prefabs that each contain the previous one `times` times. */
const nest = (count: number, times: number): Prefab[] =>
  Array.from({ length: count }, (_, i) => {
    const inner = Array.from({ length: i === 0 ? 0 : times }, (_, n) => object(`p${i}-${n}`, `p${i}`, `p${i - 1}`));
    return { id: `p${i}`, name: `p${i}`, objects: [object(`p${i}`), ...inner] };
  });

/** Greatest number of steps per character of a file: twice what any of these files takes. */
const STEPS = 4;

const lettersOf = (input: unknown): number => (typeof input === 'string' ? input : JSON.stringify(input)).length;

/** Error that refuses a file, after work that is linear in its size. */
async function refusal(input: unknown, options?: Parameters<typeof parseFile>[1]): Promise<FileError> {
  let thrown: unknown = null;
  const work = await workOf(() => {
    try {
      parseFile(input, options);
    } catch (error) {
      thrown = error;
    }
  });
  expect(work / lettersOf(input)).toBeLessThan(STEPS);
  expect(thrown).toBeInstanceOf(FileError);
  expect((thrown as FileError).message.length).toBeLessThan(2000);
  return thrown as FileError;
}

describe('a file is checked by work that grows with its size alone', () => {
  test('prefabs that hold one another without a circle', async () => {
    // each contains all earlier ones: 2²² paths through them
    const prefabs = Array.from({ length: 23 }, (_, i): Prefab => {
      const inner = Array.from({ length: i }, (_, n) => object(`p${i}-${n}`, `p${i}`, `p${n}`));
      return { id: `p${i}`, name: `p${i}`, objects: [object(`p${i}`), ...inner.slice(0, 2)] };
    });
    const file = sceneOf([], prefabs);
    const work = await workOf(() => expect(parseFile(file).prefabs).toHaveLength(23));
    expect(work / lettersOf(file)).toBeLessThan(STEPS);
  });

  test('prefabs that would become too many objects are refused before one is made', async () => {
    expect((await refusal(sceneOf([], nest(45, 2)))).message).toMatch(
      /prefabs\[19\]\.objects .*more than 1,000,000 objects/,
    );
    expect((await refusal(sceneOf([object('a', null, 'p19'), object('b', null, 'p19')], nest(20, 2)))).message).toMatch(
      /objects .*more than 1,000,000 objects/,
    );
  });

  test('prefabs nested too deep, and circles of them', async () => {
    expect((await refusal(sceneOf([], nest(8000, 1)))).message).toMatch(/more than 64 deep/);
    const circle = nest(8000, 1);
    const [first, ...rest] = circle;
    const closed = [{ ...first, objects: [object('p0'), object('x', 'p0', 'p7999')] }, ...rest];
    expect((await refusal(sceneOf([], closed))).message).toMatch(
      /holds itself: p0 holds p7999 holds p7998 holds p7997 holds … holds p0\./,
    );
  });

  test('a circle of parents is told once, and shortened', async () => {
    const circle = chain(8000);
    circle[0].parent = 'o7999';
    const error = await refusal(sceneOf(circle));
    expect(error.problems).toHaveLength(1);
    expect(error.message).toMatch(/makes a cycle: o0 below o7999 below .*… below o0/);
  });

  test('what hangs below a circle does not repeat it', async () => {
    const objects = [object('a', 'b'), object('b', 'a'), ...chain(8000)];
    objects[2].parent = 'a';
    expect((await refusal(sceneOf(objects))).problems).toHaveLength(1);
  });

  test('names of prefabs, assets and components that are not there', async () => {
    const prefabs = Array.from({ length: 5000 }, (_, i): Prefab => ({
      id: `p${i}`,
      name: 'p',
      objects: [object(`p${i}`)],
    }));
    await refusal(
      sceneOf(
        Array.from({ length: 5000 }, (_, i) => object(`o${i}`, null, `gone${i}`)),
        prefabs,
      ),
    );
    const file = sceneOf(
      Array.from({ length: 5000 }, (_, i) => ({
        ...object(`o${i}`),
        components: [{ type: 'ObjectRenderer', version: 1, id: `c${i}`, values: { mesh: `gone${i}` } }],
      })),
    );
    file.assets = Array.from({ length: 5000 }, (_, i) => ({ name: `m${i}`, type: 'model' as const, url: 'a.glb' }));
    expect((await refusal(file, { assets: new Scene().assets })).problems.length).toBeGreaterThan(1);
  });
});

describe('depth', () => {
  const nested = (depth: number, open: string, close: string): string =>
    JSON.stringify(sceneOf([object('a')])).replace(
      '"components":[]',
      `"components":${open.repeat(depth)}1${close.repeat(depth)}`,
    );

  test('parents are taken 500 deep and no deeper', async () => {
    const scene = await deserialize(sceneOf(chain(500)));
    scene.three.updateMatrixWorld();
    scene.dispose();
    expect((await refusal(sceneOf(chain(501)))).message).toMatch(/objects\[500\]\.parent .*501 objects deep.*500/);
    expect((await refusal(sceneOf(chain(50_000).toReversed()))).problems).toHaveLength(1);
  });

  test('values nested too deep', async () => {
    for (const text of [nested(4000, '[', ']'), nested(200_000, '{"a":', '}'), nested(5000, '[{"a":', '}]')]) {
      expect((await refusal(text)).message).toMatch(/more than 32 deep/);
    }
  });

  test('a scene takes no object deeper than its file could be read again', () => {
    const scene = new Scene();
    return deserialize(sceneOf(chain(500))).then((deep) => {
      const root = deep.roots[0];
      scene.add(root);
      const top = deep.scene;
      top.dispose();
      let deepest = root;
      while (deepest.children.length > 0) deepest = deepest.children[0];
      const extra = root.clone();
      expect(() => deepest.add(extra)).toThrow(/more than 500 objects deep/);
      expect(extra.parent).toBeNull();
      expect(deepest.children).toHaveLength(0);
    });
  });
});

test('a prefab is looked for in others in one visit to each, and must not come to too many objects', async () => {
  const scene = new Scene();
  const prefabs = Array.from({ length: 36 }, (_, i): Prefab => {
    const inner = [i - 1, i - 2].filter((n) => n >= 0);
    return {
      id: `p${i}`,
      name: `p${i}`,
      objects: [object(`p${i}`), ...inner.map((n) => object(`${i}-${n}`, `p${i}`, `p${n}`))],
    };
  });
  for (const prefab of prefabs) scene.prefabs.set(prefab);
  const work = await workOf(() => {
    expect(scene.prefabs.contains('p35', 'none')).toBe(false);
    expect(scene.prefabs.contains('p35', 'p0')).toBe(true);
  });
  // 36 prefabs, twice; as many paths as the 36th Fibonacci number
  expect(work).toBeLessThan(2000);
  expect(() => changePrefab(scene, { ...prefabs[0], objects: [object('p0'), object('x', 'p0', 'p35')] })).toThrow(
    /'p0' would hold itself/,
  );
  expect(() => changePrefab(scene, { ...prefabs[0], name: 'other' })).toThrow(
    /'p\d+' would come to more than 1,000,000/,
  );
  scene.dispose();
});

test('names that every object has are names as any others', async () => {
  const names = ['__proto__', 'constructor', 'toString'];
  const texts = names.map((name) => `${JSON.stringify(name)}:"// ${name}"`).join();
  const text = JSON.stringify(sceneOf(names.map((name) => object(name)))).replace(
    '"objects"',
    `"microShaders":{${texts}},"objects"`,
  );
  const scene = await deserialize(text);
  expect([...scene.microShaders.texts.keys()]).toEqual(names);
  expect(scene.findById('__proto__')?.name).toBe('__proto__');
  const saved = JSON.stringify(serialize(scene));
  expect(JSON.stringify(serialize(await deserialize(saved)))).toBe(saved);
  expect(Object.keys(JSON.parse(saved).microShaders).toSorted()).toEqual(names.toSorted());
  scene.dispose();
});
