import { isFieldVisible } from '@farol/editing/fields';
import { particleDefaults, particlePresets, type ParticleSettings } from '@farol/renderer/particles';
import { BoxGeometry, Mesh } from 'three';
import { expect, test } from 'vitest';
import { createRandom } from '../base/createRandom';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { particleValues } from './particleSettings';
import { randomFieldValue } from '../fields/randomFieldValue';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { ObjectRenderer } from './ObjectRenderer';
import { ParticleEmitter } from './ParticleEmitter';
import { particleCode, particlePreset } from './particleCode';
import { particleFields } from './particleFields';
import { particleSettings, type ParticleValues } from './particleSettings';

function emitterIn(scene: Scene, values: Parameters<GameObject['addComponent']>[1] = {}): ParticleEmitter {
  const object = new GameObject('Fire');
  scene.add(object);
  return object.addComponent(ParticleEmitter, values);
}

/** Number of particles that the emitter's schedule has begun. */
const begun = (emitter: ParticleEmitter): number => emitter.three!.pending.schedule.begun;

test('it is made once its code is there, if it is still in the scene, and goes on as if it had been there', async () => {
  const scene = new Scene();
  const early = emitterIn(scene);
  const left = emitterIn(scene);
  scene.remove(left.gameObject);
  scene.update(0.5);
  await particleCode.load();
  expect(early.three!.parent).toBe(early.gameObject.object3D);
  expect(early.three!.time).toBeCloseTo(0.5, 9);
  expect(begun(early)).toBe(50);
  expect(left.three).toBeNull();
  expect(scene.requiredEffects).toHaveLength(1);
  scene.remove(early.gameObject);
  expect(early.three).toBeNull();
  expect(scene.requiredEffects).toHaveLength(0);
});

const noParts = { colliders: [], surface: null, mesh: null, texture: null };

test('without values the settings are the renderer’s, less what a curve says in fewer keys', () => {
  const made = particleSettings(new ParticleEmitter(), noParts);
  const { sizeOverLife, spinOverLife, ...rest } = made;
  const { sizeOverLife: _size, spinOverLife: _spin, ...defaults } = particleDefaults;
  expect(rest).toEqual({ ...defaults, lightIntensity: 1 });
  expect([sizeOverLife, spinOverLife]).toEqual([[[0, 1]], [[0, 1]]]);
});

test.each(Object.keys(particlePresets) as (keyof typeof particlePresets)[])(
  'the fields of the preset %s make its settings',
  async (name) => {
    const scene = new Scene();
    const settings: Partial<ParticleSettings> = particlePresets[name];
    const { three } = emitterIn(scene, await particlePreset(name));
    for (const [key, value] of Object.entries(settings)) {
      expect(three!.settings[key as keyof ParticleSettings], key).toEqual(value);
    }
  },
);

test('fields of whatever value that they allow make settings that the renderer allows', () => {
  const random = createRandom(3);
  const scene = new Scene();
  const emitter = emitterIn(scene, { mesh: null });
  for (let n = 0; n < 200; n++) {
    for (const [name, field] of Object.entries(particleFields)) {
      if (random() < 0.2) emitter.set(name, randomFieldValue(field, random, []));
    }
    const all = Object.fromEntries(Object.keys(particleFields).map((name) => [name, emitter.get(name)]));
    const wanted = particleSettings(all as unknown as ParticleValues, noParts);
    expect(emitter.three!.settings).toEqual(wanted);
  }
});

test('a plane without a direction faces up, and ranges may be given either way round', () => {
  const emitter = emitterIn(new Scene(), { collides: true, planeNormal: [0, 0, 0], lifeFrom: 3, lifeTo: 1 });
  expect(emitter.three!.colliders).toEqual([
    { kind: 'plane', normal: [0, 1, 0], height: 0, bounce: 0.5, friction: 0.2 },
  ]);
  expect(emitter.three!.life).toEqual([1, 3]);
});

test('objects that particles bounce off are planes along their +Y or spheres of their scale, wherever they go', () => {
  const scene = new Scene();
  const [wall, ball] = ['Wall', 'Ball'].map((name) => new GameObject(name));
  scene.add(wall);
  scene.add(ball);
  wall.object3D.position.set(2, 0, 0);
  wall.object3D.rotation.z = Math.PI / 2;
  ball.object3D.scale.setScalar(3);
  const emitter = emitterIn(scene, { collides: true, bounce: 1, friction: 0, collider1: wall.id, collider3: ball.id });
  const surface = { bounce: 1, friction: 0 };
  const near = (numbers: readonly number[]) => numbers.map((n) => expect.closeTo(n, 6) as number);
  const floor = { kind: 'plane', normal: [0, 1, 0], height: 0, ...surface };
  expect(emitter.three!.colliders).toEqual([
    floor,
    { kind: 'plane', normal: near([-1, 0, 0]), height: expect.closeTo(-2, 6) as number, ...surface },
    { kind: 'plane', normal: [0, 1, 0], height: 0, ...surface },
  ]);
  emitter.colliderKind = 'sphere';
  wall.object3D.position.y = 5;
  scene.update(0.1);
  const { colliders } = emitter.three!;
  expect(colliders).toEqual([
    floor,
    { kind: 'sphere', center: [2, 5, 0], radius: expect.closeTo(0.5, 6) as number, ...surface },
    { kind: 'sphere', center: [0, 0, 0], radius: 1.5, ...surface },
  ]);
  scene.update(0.1);
  expect(emitter.three!.colliders, 'kept while nothing moves').toBe(colliders);
  scene.remove(wall);
  scene.update(0.1);
  expect(emitter.three!.colliders.map(({ kind }) => kind)).toEqual(['plane', 'sphere']);
  emitter.collides = false;
  expect(emitter.three!.colliders).toEqual([]);
});

test('bursts repeat at an interval, after a delay; space and orientation are told', () => {
  const emitter = emitterIn(new Scene(), {
    ...{ rate: 0, burstCount: 4, burstTime: 0.1, burstRepeats: 3, burstInterval: 0.2, delay: 1 },
    ...{ space: 'local', orientation: 'velocity' },
  });
  const { three } = emitter;
  expect(three!.bursts).toEqual([0, 1, 2].map((i) => ({ time: 0.1 + i * 0.2, count: 4 })));
  expect([three!.delay, three!.space, three!.orientation]).toEqual([1, 'local', 'velocity']);
  expect(particleValues(three!.settings)).toMatchObject({
    ...{ burstCount: 4, burstTime: 0.1, burstRepeats: 3, delay: 1, space: 'local', orientation: 'velocity' },
  });
  emitter.advance(1.35);
  expect(begun(emitter)).toBe(8);
});

test('play begins from the seed whatever was shown before, and a reset brings the beginning back', () => {
  const scene = new Scene();
  const emitter = emitterIn(scene, { burstCount: 7, burstTime: 0.25 });
  emitter.advance(3.3);
  expect(begun(emitter)).toBe(337);
  scene.update(0.1);
  expect(emitter.three!.time).toBeCloseTo(0.1, 9);
  expect(begun(emitter)).toBe(10);
  for (let i = 0; i < 9; i++) scene.update(0.1);
  expect(begun(emitter)).toBe(107);
  scene.reset();
  expect(emitter.three!.time).toBe(0);
  expect(begun(emitter)).toBe(0);
  scene.setTime(1);
  expect(begun(emitter)).toBe(107);
});

test('it begins anew when it is switched on, or a setting has it begin anew, while the scene plays', () => {
  const scene = new Scene();
  const emitter = emitterIn(scene);
  scene.update(2);
  emitter.enabled = false;
  expect(emitter.three!.visible).toBe(false);
  scene.update(1);
  emitter.enabled = true;
  expect(begun(emitter)).toBe(0);
  scene.update(0.5);
  expect(begun(emitter)).toBe(50);
  emitter.seed = 5;
  scene.update(0.1);
  expect(begun(emitter)).toBe(10);
  emitter.brightness = 3;
  scene.update(0.1);
  expect(begun(emitter)).toBe(20);
  scene.reset();
  expect(begun(emitter)).toBe(0);
});

test('it can be told to emit or not, which a reset takes back', () => {
  const scene = new Scene();
  const emitter = emitterIn(scene);
  scene.update(0.1);
  emitter.stop();
  scene.update(1);
  expect(begun(emitter)).toBe(10);
  emitter.emit();
  scene.update(0.1);
  expect(begun(emitter)).toBe(20);
  emitter.stop();
  scene.reset();
  expect(emitter.emitting).toBe(true);
  expect(emitter.three!.emitting).toBe(true);
});

test('it begins on the mesh of its object or of another one, which may come later', () => {
  const scene = new Scene();
  const emitter = emitterIn(scene, { shape: 'mesh' });
  expect(emitter.three!.shape).toEqual({ kind: 'mesh', mesh: null });
  const renderer = emitter.gameObject.addComponent(ObjectRenderer);
  emitter.advance(0.1);
  expect(emitter.three!.shape).toEqual({ kind: 'mesh', mesh: renderer.three });
  const other = new GameObject('Model');
  const part = new Mesh(new BoxGeometry());
  other.object3D.add(part);
  scene.add(other);
  emitter.surface = other.id;
  expect(emitter.three!.shape).toEqual({ kind: 'mesh', mesh: part });
});

test('it has its texture and its mesh from the library, and gives them back', () => {
  const scene = new Scene();
  const emitter = emitterIn(scene, { texture: 'checker', render: 'mesh', mesh: 'box' });
  const { texture, particleGeometry } = emitter.three!;
  expect(texture).toBe(scene.assets.texture('checker'));
  expect(particleGeometry).toBe(scene.assets.mesh('box'));
  expect(scene.assets.uses.size).toBe(2);
  emitter.texture = null;
  expect(emitter.three!.texture).toBeNull();
  scene.remove(emitter.gameObject);
  expect(scene.assets.uses.size).toBe(0);
});

test('fields are shown only where they matter', () => {
  const emitter = new ParticleEmitter();
  const visible = (name: string): boolean => isFieldVisible(emitter.fields, name, (field) => emitter.get(field));
  const hidden = ['thickness', 'boxSize', 'surface', 'planeHeight', 'mesh', 'stretch', 'columns', 'lightRange'];
  expect(hidden.filter(visible)).toEqual([]);
  Object.assign(emitter, { shape: 'box', collides: true, render: 'stretched', flipBook: true, shine: true });
  expect(['boxSize', 'planeHeight', 'stretch', 'columns', 'lightRange'].filter((name) => !visible(name))).toEqual([]);
  emitter.render = 'mesh';
  expect(visible('columns')).toBe(false);
  expect(visible('mesh')).toBe(true);
});

test('its curves and gradients are kept in files, and whoever reads the file cannot change them', async () => {
  const scene = new Scene();
  emitterIn(scene, {
    sizeOverLife: [
      [0, 0],
      [0.4, 2],
      [0.4, 1],
    ],
    colourOverLife: [
      [0, [4, 1, 0], null],
      [0.5, null, 1],
    ],
  });
  const file = serialize(scene);
  const text = JSON.stringify(file);
  const [component] = file.objects[0].components.filter(({ type }) => type === 'ParticleEmitter');
  (component.values.sizeOverLife as unknown as number[][])[0][1] = 9;
  const [emitter] = scene.componentsOf(ParticleEmitter);
  expect(emitter.sizeOverLife[0]).toEqual([0, 0]);
  const [again] = (await deserialize(JSON.parse(text))).componentsOf(ParticleEmitter);
  expect(again.sizeOverLife).toEqual(emitter.sizeOverLife);
  expect(again.colourOverLife).toEqual(emitter.colourOverLife);
  (component.values.colourOverLife as unknown as unknown[][])[0][1] = [1, -1, 0];
  await expect(deserialize(file)).rejects.toThrow(/colourOverLife.*must be 1 to 64 keys/);
});
