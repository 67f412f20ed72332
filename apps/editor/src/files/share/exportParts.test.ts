import { AssetLibrary, builtinComponents, GameObject, Scene } from '@farol/engine';
import { afterAll, beforeAll, beforeEach, expect, test, vi } from 'vitest';
import { exportHtml } from './exportHtml';

/** Files of the editor's site that were requested. */
const asked: string[] = [];

beforeAll(() => {
  vi.stubGlobal('document', { baseURI: 'https://editor.test/folder/' });
  vi.stubGlobal('fetch', async (address: URL) => {
    const name = address.href.replace('https://editor.test/folder/', '');
    asked.push(name);
    return new Response(`/* ${name} */`);
  });
});
beforeEach(() => void asked.splice(0));
afterAll(() => void vi.unstubAllGlobals());

const script = `import { component } from '@farol/engine/fields';
export default class Spin extends component({}) {}`;

const compressed = JSON.stringify({ asset: { version: '2.0' }, extensionsUsed: ['KHR_draco_mesh_compression'] });

/** Names of the files requested for a page with one object with these components. */
async function partsOf(types: readonly string[], fill: (assets: AssetLibrary) => void = () => {}): Promise<string[]> {
  const assets = new AssetLibrary();
  const scene = new Scene({ assets });
  const object = new GameObject('Object');
  scene.add(object);
  for (const type of types) if (type !== 'Transform') object.addComponent(type);
  fill(assets);
  const page = await (await exportHtml(scene, { withScripts: true })).text();
  scene.dispose();
  const [player] = asked.filter((name) => !name.includes('physics'));
  expect(page).toContain(`/* ${player} */`);
  expect(page.includes('id="farol-physics"')).toBe(asked.includes('farol-player-physics.js'));
  return asked.toSorted();
}

/** Types of components that need the physics engine. */
const needPhysics = [...builtinComponents.types]
  .filter(([, type]) => Object.getPrototypeOf(type).name === 'PhysicsComponent')
  .map(([name]) => name);

test('four components need physics', () => {
  expect(needPhysics.toSorted()).toEqual(['CharacterController', 'Collider', 'Joint', 'RigidBody']);
});

test.each([...builtinComponents.types.keys()])('a page has what a scene with %s needs, and no more', async (type) => {
  const player = type === 'ParticleEmitter' ? 'farol-player-particles.js' : 'farol-player.js';
  const physics = needPhysics.includes(type) ? ['farol-player-physics.js'] : [];
  expect(await partsOf([type])).toEqual([...physics, player].toSorted());
});

test.each([
  ['scripts', [], true, false, ['farol-player-scripts.js']],
  ['compressed models', [], false, true, ['farol-player-decoders.js']],
  ['scripts and compressed models', [], true, true, ['farol-player-scripts-decoders.js']],
  ['particles and compressed models', ['ParticleEmitter'], false, true, ['farol-player-particles-decoders.js']],
  ['particles and scripts', ['ParticleEmitter'], true, false, ['farol-player-scripts.js']],
  ['bodies and scripts', ['RigidBody'], true, false, ['farol-player-physics.js', 'farol-player-scripts.js']],
] as const)('a page has what %s need', async (_, types, hasScript, hasModel, parts) => {
  const fill = (assets: AssetLibrary): void => {
    if (hasScript) assets.addFieldAsset('script', 'Spin', { source: script });
    if (hasModel) assets.registerFile('dragon.gltf', new Blob([compressed]));
  };
  expect(await partsOf(types, fill)).toEqual(parts);
});

test('what a script alone brings in has its part: bodies that it adds', async () => {
  const source = `${script}\nexport const add = (object) => object.addComponent('RigidBody');`;
  const fill = (assets: AssetLibrary): void => void assets.addFieldAsset('script', 'Spin', { source });
  expect(await partsOf([], fill)).toContain('farol-player-physics.js');
});
