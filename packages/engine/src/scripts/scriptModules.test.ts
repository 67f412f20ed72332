import { currentOf } from '@farol/editing';
import { expect, test } from 'vitest';
import { builtinComponents } from '../components/index';
import { ComponentRegistry } from '../core/ComponentRegistry';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { compileScript } from './compileScript';
import { inNode } from './testing/inNode';
import { SceneScripts } from './SceneScripts';
import { ScriptError } from './ScriptError';
import { placeOfError, scriptUrl } from './scriptUrl';

const imports = "import { component, number } from '@farol/engine/fields';\n";

async function make(sources: Record<string, string>): Promise<{ scene: Scene; scripts: SceneScripts }> {
  const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
  const scene = new Scene({ registry });
  for (const [name, source] of Object.entries(sources)) scene.assets.addFieldAsset('script', name, { source });
  const scripts = new SceneScripts(scene, registry, inNode);
  await scripts.settled();
  return { scene, scripts };
}

const messages = ({ scripts }: { scripts: SceneScripts }): string[] =>
  [...scripts.errors.values()].map(({ message }) => message).toSorted();

test('types are taken out, and each line stays where it is', async () => {
  const source = `${imports}
interface Point { x: number }
export default class Spin extends component({ rate: number(1, { help: '' }) }) {
  declare point: Point;
  override update(delta: number): void {
    for (let i = 0; i < 2; i++) this.rate += delta as number;
    while (false) break;
    throw new Error('at line nine');
  }
}`;
  const compiled = await compileScript('Spin', source);
  expect(compiled).not.toBeInstanceOf(ScriptError);
  const lines = (compiled as { code: string }).code.split('\n');
  expect(lines[3]).toContain('class Spin');
  expect(lines[8]).toContain("throw new Error('at line nine')");
  const { scene } = await make({ 'My folder/Spin (2)': source });
  const object = new GameObject();
  scene.add(object);
  object.addComponent('Spin (2)');
  const errors: unknown[] = [];
  scene.onComponentError = (_component, error) => errors.push(error);
  scene.update(0.1);
  expect(placeOfError(errors[0], ['My folder/Spin (2)'])).toMatchObject({ script: 'My folder/Spin (2)', line: 9 });
  expect(scriptUrl('My folder/Spin (2)')).toBe('farol-scripts/My%20folder/Spin%20%282%29.ts');
});

test('JavaScript stays as it is, and has no types', async () => {
  const good = await compileScript('a.js', 'export const one = 1;');
  expect(good).toMatchObject({ name: 'a.js' });
  expect(await compileScript('a.js', 'export const one: number = 1;')).toMatchObject({ script: 'a.js', line: 1 });
});

test('scripts import each other, three and the engine', async () => {
  const main = `${imports}import * as THREE from 'three';
import { Light } from '@farol/engine';
import { speed } from './tools/speed';
export default class Run extends component({ rate: number(speed, { help: '' }) }) {
  readonly at = new THREE.Vector3(1, 2, 3);
  static readonly light = Light;
}`;
  const { scene, scripts } = await make({
    Run: main,
    'tools/speed.ts': "import { half } from '../half.js';\nexport const speed = half * 8;",
    'half.js': 'export const half = 0.5;',
  });
  expect([...scripts.errors]).toEqual([]);
  const object = new GameObject();
  scene.add(object);
  const run = object.addComponent('Run');
  expect(run.get('rate')).toBe(4);
  expect(run).toMatchObject({ at: { x: 1, y: 2, z: 3 } });
  expect(scripts.classOf('half.js')).toBeNull();
  // scripts that import it run again too
  scene.assets.fieldAsset('half.js')!.set('source', 'export const half = 1;');
  await scripts.settled();
  expect(currentOf(run).get('rate')).toBe(8);
});

test('what cannot be imported is told with script, line and mend', async () => {
  const made = await make({
    A: "\nimport './B';\nexport const a = 1;",
    B: "import './A';",
    C: "import 'fs';",
    D: "\n\nimport { x } from './gone';\nx();",
  });
  expect(messages(made)).toEqual(
    [
      'B, line 1: it imports itself in a circle: A imports B imports A. Move what they share to a script of its own.',
      "C, line 1: it imports 'fs', which is not there: scripts can import 'three', '@farol/engine', '@farol/engine/fields', and other scripts as './name'.",
      "D, line 3: it imports './gone', and there is no such script: create it, or correct the name.",
    ]
      .flatMap((message, i) =>
        i === 0
          ? [
              message,
              message.replace('A imports B imports A', 'B imports A imports B').replace('B, line 1', 'A, line 2'),
            ]
          : [message],
      )
      .toSorted(),
  );
});

test('a default export that is no class of components, a field that is none and a name that is taken are told', async () => {
  const made = await make({
    A: 'export default 3;',
    B: `${imports}\nexport default class B extends component({ rate: 3 }) {}`,
    Light: `${imports}export default class extends component({}) {}`,
    C: `${imports}export default class extends component({}) { constructor() { super();\n throw new Error('no'); } }`,
    'x/Twice': `${imports}export default class extends component({}) {}`,
    'y/Twice': `${imports}export default class extends component({}) {}`,
  });
  expect(messages(made)).toEqual([
    'A, line 1: its default export is not a component class: write `export default class … extends component({ … })`.',
    "B, line 3: its field 'rate' is not declared: write number(1), boolean(true) or another field of '@farol/engine/fields'.",
    'C, line 3: no',
    "Light: there is a component 'Light' of Farol or a plugin already: give the script another name, or its class another typeName.",
    "y/Twice: there is a component 'Twice' of the script x/Twice already: give the script another name, or its class another typeName.",
  ]);
});

test('a loop without an end is left after two seconds, its component is off until the scene is reset, the others go on', async () => {
  const body = (text: string): string =>
    `${imports}export default class extends component({ count: number(0, { help: '' }) }) { update() { ${text} } }`;
  const { scene, scripts } = await make({
    Endless: body('for (;;) this.n = 1;'),
    Counter: body('this.n = (this.n ?? 0) + 1;'),
  });
  expect([...scripts.errors]).toEqual([]);
  const object = new GameObject('Top');
  scene.add(object);
  const endless = object.addComponent('Endless');
  const counter = object.addComponent('Counter');
  const errors: string[] = [];
  scene.onComponentError = (_component, error) => errors.push((error as Error).message);
  const clock = performance.now.bind(performance);
  let ahead = 0;
  // makes the clock faster than the test
  performance.now = () => clock() + (ahead += 100);
  try {
    scene.update(0.1);
    scene.update(0.1);
  } finally {
    performance.now = clock;
  }
  expect(errors).toEqual(['A loop has gone on for 2 s: give it an end, or do its work over several frames.']);
  expect(scene.isSwitchedOff(endless)).toBe(true);
  expect(endless.enabled).toBe(true);
  expect(counter).toMatchObject({ n: 2 });
  expect(scene.callMethod('update', 0)).toBe(2);
  scene.reset();
  expect(scene.isSwitchedOff(endless)).toBe(false);
});
