import type { PointLight } from 'three';
import { describe, expect, test } from 'vitest';
import './index';
import { Animation } from './Animation';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { deserialize } from '../files/deserialize';
import { parseFile } from '../files/parseFile';
import { serialize } from '../files/serialize';
import { Light } from './Light';
import { LightGroup } from './LightGroup';
import { soloLights } from './lightGroups';
import { ParticleEmitter } from './ParticleEmitter';
import { particleCode } from './particleCode';
import { addClip, keys, track } from './testing/clipStage';

function street(count = 2) {
  const scene = new Scene();
  const desk = new GameObject('Lamps');
  scene.add(desk);
  const group = desk.addComponent(LightGroup);
  const lights = Array.from({ length: count }, (_, i) => {
    const lamp = new GameObject(`Lamp ${i}`);
    scene.add(lamp);
    return lamp.addComponent(Light, { intensity: i + 1, diffuse: [1, 0.5, 0.25], group: desk.id });
  });
  return { scene, desk, group, lights };
}

const shining = (lights: readonly Light[]): number[] => lights.map(({ three }) => three.intensity);

describe('the master of a group', () => {
  test('multiplies the intensities and colours of its lights, whose own values stay', () => {
    const { group, lights } = street();
    group.dimmer = 0.5;
    group.colour = [1, 1, 2];
    expect(shining(lights)).toEqual([0.5, 1]);
    expect(lights[0].three.color.toArray()).toEqual([1, 0.5, 0.5]);
    expect(lights.map((light) => [light.intensity, light.diffuse])).toEqual([
      [1, [1, 0.5, 0.25]],
      [2, [1, 0.5, 0.25]],
    ]);
    lights[1].intensity = 10;
    expect(shining(lights)).toEqual([0.5, 5]);
    group.dimmer = 1;
    group.colour = [1, 1, 1];
    expect(shining(lights)).toEqual([1, 10]);
    expect(lights[0].three.color.toArray()).toEqual([1, 0.5, 0.25]);
  });

  test('tints what three has no field for, and the ground of a hemisphere', () => {
    const { group, lights } = street(1);
    lights[0].ambient = [0.5, 0, 0];
    lights[0].ownSpecular = true;
    group.colour = [0.5, 0.25, 1];
    expect(lights[0].three.userData.farol).toMatchObject({ ambient: [0.25, 0, 0], specular: [0.5, 0.25, 1] });
    lights[0].type = 'hemisphere';
    lights[0].groundColour = [1, 1, 1];
    const { groundColor } = lights[0].three as unknown as { groundColor: { toArray(): number[] } };
    expect(groundColor.toArray()).toEqual([0.5, 0.25, 1]);
  });

  test('makes its lights dark while it is off, or its object is', () => {
    const { desk, group, lights } = street();
    group.enabled = false;
    expect(shining(lights)).toEqual([0, 0]);
    group.enabled = true;
    desk.active = false;
    expect(shining(lights)).toEqual([0, 0]);
    desk.active = true;
    expect(shining(lights)).toEqual([1, 2]);
  });

  test('leaves lights alone that go to no group, or whose group is gone', () => {
    const { scene, desk, group, lights } = street();
    group.dimmer = 0.5;
    lights[0].group = null;
    expect(shining(lights)).toEqual([1, 1]);
    desk.removeComponent(group);
    expect(shining(lights)).toEqual([1, 2]);
    desk.addComponent(LightGroup, { dimmer: 2 });
    expect(shining(lights)).toEqual([1, 4]);
    const other = new Scene();
    other.add(lights[1].gameObject);
    expect([lights[1].scene, shining(lights)]).toEqual([other, [1, 2]]);
    scene.dispose();
  });

  test('dims the lights of particles, whose own value stays, in whatever order they are put into it', async () => {
    await particleCode.load();
    const { scene, desk, group } = street();
    group.dimmer = 0.5;
    const fire = new GameObject('Fire');
    const emitter = fire.addComponent(ParticleEmitter, { shine: true, lightIntensity: 3, group: desk.id });
    scene.add(fire);
    const shines = (): number => emitter.three!.lightIntensity;
    expect(shines()).toBe(1.5);
    group.dimmer = 0.25;
    expect([shines(), emitter.lightIntensity]).toEqual([0.75, 3]);
    emitter.lightIntensity = 4;
    expect(shines()).toBe(1);
    emitter.group = null;
    expect(shines()).toBe(4);
    emitter.group = desk.id;
    group.enabled = false;
    expect(shines()).toBe(0);
    desk.removeComponent(group);
    expect(shines()).toBe(4);
  });

  test('is saved with the scene, and works in whatever order its parts are read', async () => {
    const { scene, group } = street();
    group.dimmer = 0.25;
    const file = JSON.stringify(serialize(scene));
    for (const order of [1, -1]) {
      const parsed = JSON.parse(file) as { objects: object[] };
      if (order < 0) parsed.objects.reverse();
      const read = await deserialize(parseFile(JSON.stringify(parsed)));
      const lights = read.componentsOf(Light).toSorted((a, b) => a.intensity - b.intensity);
      expect(shining(lights)).toEqual([0.25, 0.5]);
    }
  });

  test('is moved by a timeline: all lamps fade, and are as before when it stops', () => {
    const { scene, desk, lights } = street();
    addClip(scene, 'Fade', { tracks: [track('dimmer', keys([0, 1], [2, 0]), '', 'LightGroup')] });
    desk.addComponent(Animation, { clip: 'Fade', wrap: 'once' });
    scene.update(1);
    expect(shining(lights)).toEqual([0.5, 1]);
    scene.update(2);
    expect(shining(lights)).toEqual([0, 0]);
    scene.reset();
    expect(shining(lights)).toEqual([1, 2]);
  });

  test('a dimmer, and a light’s own intensity, set intensities, and nothing else of any light', () => {
    const { group, lights, scene } = street(3);
    lights[2].group = null;
    let applied = 0;
    for (const light of scene.componentsOf(Light)) {
      const { applyFields } = light;
      light.applyFields = () => {
        applied++;
        applyFields.call(light);
      };
    }
    group.dimmer = 0.5;
    expect([applied, ...shining(lights)]).toEqual([0, 0.5, 1, 3]);
    lights[1].intensity = 4;
    expect([applied, ...shining(lights)]).toEqual([0, 0.5, 2, 3]);
    group.colour = [1, 0, 0];
    expect(applied).toBe(2);
  });
});

describe('lights shown alone', () => {
  test('leave the others dark, those that come later too, and nothing of it is saved', () => {
    const { scene, lights } = street();
    const file = JSON.stringify(serialize(scene));
    soloLights(scene, new Set([lights[0].id]));
    const visible = (): boolean[] => lights.map(({ three }) => three.visible);
    expect(visible()).toEqual([true, false]);
    lights[1].type = 'spot';
    lights[1].type = 'point';
    expect(visible()).toEqual([true, false]);
    const late = new GameObject('Late');
    scene.add(late);
    expect((late.addComponent(Light).three as PointLight).visible).toBe(false);
    scene.remove(late);
    expect(JSON.stringify(serialize(scene))).toBe(file);
    soloLights(scene, null);
    expect(visible()).toEqual([true, true]);
  });

  test('leave the light of particles dark, which are seen as before', async () => {
    await particleCode.load();
    const { scene, lights } = street();
    const fire = new GameObject('Fire');
    scene.add(fire);
    const emitter = fire.addComponent(ParticleEmitter, { shine: true });
    const state = (): boolean[] => [emitter.three!.visible, emitter.three!.lights!.visible];
    soloLights(scene, new Set([lights[0].id]));
    expect(state()).toEqual([true, false]);
    emitter.lightEvery = 5;
    expect(state()).toEqual([true, false]);
    soloLights(scene, new Set([emitter.id]));
    expect([...state(), lights[0].three.visible]).toEqual([true, true, false]);
  });
});
