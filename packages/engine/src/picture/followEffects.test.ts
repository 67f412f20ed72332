import type { FarolEffect, FarolRenderer } from '@farol/renderer';
import { beforeEach, expect, test, vi } from 'vitest';
import { Component } from '../core/Component';
import { GameObject } from '../core/GameObject';
import type { RequiredEffect } from '../core/RequiredEffect';
import { Scene } from '../core/Scene';
import { followEffects } from './followEffects';

class Glow {
  readonly name = 'glow';
}

/** An effect whose code is loaded when the test decides. */
const glow = {
  effectClass: null as RequiredEffect['effectClass'],
  come: (): void => {},
  load: vi.fn<() => Promise<void>>(() => new Promise((resolve) => (glow.come = resolve))),
};

class Glowing extends Component {
  static override readonly typeName: string = 'Glowing';
  static override readonly effect: RequiredEffect = glow;
}

const rendererWith = (...effects: FarolEffect[]): FarolRenderer => ({ effects }) as unknown as FarolRenderer;
const other = { name: 'other' } as FarolEffect;

function glowingScene(count: number): Scene {
  const scene = new Scene();
  for (let i = 0; i < count; i++) {
    const object = new GameObject();
    object.addComponent(Glowing);
    scene.add(object);
  }
  return scene;
}

beforeEach(() => {
  glow.effectClass = Glow as unknown as RequiredEffect['effectClass'];
  glow.load.mockClear();
});

test('a renderer has the effect while a component of the scene needs it, before its others', () => {
  const renderer = rendererWith(other);
  const scene = glowingScene(2);
  followEffects(renderer, scene);
  expect(renderer.effects.map(({ name }) => name)).toEqual(['glow', 'other']);
  const { effects } = renderer;
  scene.remove(scene.roots[0]);
  followEffects(renderer, scene);
  expect(renderer.effects).toBe(effects);
  scene.remove(scene.roots[0]);
  followEffects(renderer, scene);
  expect(renderer.effects).toEqual([other]);
  followEffects(renderer, glowingScene(1));
  expect(renderer.effects[0]).toBe(effects[0]);
});

test("an effect of the host's own stays, and is the only one", () => {
  const own = new Glow() as unknown as FarolEffect;
  const renderer = rendererWith(own);
  followEffects(renderer, glowingScene(1));
  followEffects(renderer, new Scene());
  expect(renderer.effects).toEqual([own]);
});

test('its code is fetched once, and the host is told when it has come', async () => {
  glow.effectClass = null;
  const renderer = rendererWith();
  const scene = glowingScene(1);
  const redraw = vi.fn<() => void>();
  for (let i = 0; i < 3; i++) followEffects(renderer, scene, redraw);
  expect(glow.load).toHaveBeenCalledTimes(1);
  expect(renderer.effects).toEqual([]);
  glow.effectClass = Glow as unknown as RequiredEffect['effectClass'];
  glow.come();
  await vi.waitFor(() => expect(redraw).toHaveBeenCalledTimes(1));
  followEffects(renderer, scene, redraw);
  expect(renderer.effects.map(({ name }) => name)).toEqual(['glow']);
});

test('a scene without such components asks nothing of the renderer', () => {
  const renderer = Object.defineProperty({}, 'effects', { get: () => expect.fail('asked') }) as FarolRenderer;
  followEffects(renderer, new Scene());
  expect(new Scene().requiredEffects).toEqual([]);
});
