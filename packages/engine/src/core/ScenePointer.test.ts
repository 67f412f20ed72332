import { beforeEach, expect, test } from 'vitest';
import '../components/index';
import { Camera } from '../components/Camera';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { InputRouter, type InputSurface } from '../app/InputRouter';
import { Component } from './Component';
import type { EngineKeyEvent, ObjectPointerEvent } from './events';
import { GameObject } from './GameObject';
import { Scene } from './Scene';

const calls: string[] = [];

class Noter extends Component {
  static override readonly typeName = 'Noter';
  stops = false;
  throws = false;
  last: ObjectPointerEvent | null = null;
  private note(name: string, event: ObjectPointerEvent): void {
    calls.push(`${name} ${this.gameObject.name}`);
    this.last = event;
    if (this.stops) event.stopPropagation();
    if (this.throws) throw new Error(`${name} failed`);
  }
  override onPointerOver(event: ObjectPointerEvent): void {
    this.note('over', event);
  }
  override onPointerOut(event: ObjectPointerEvent): void {
    this.note('out', event);
  }
  override onPointerPress(event: ObjectPointerEvent): void {
    this.note('press', event);
  }
  override onPointerRelease(event: ObjectPointerEvent): void {
    this.note('release', event);
  }
  override onPointerClick(event: ObjectPointerEvent): void {
    this.note('click', event);
  }
  override onKeyDown(event: EngineKeyEvent): void {
    calls.push(`key ${event.code}`);
    if (this.throws) throw new Error('key failed');
  }
}

/** A canvas of 100 × 100 pixels with a camera at (0, 0, 10) that faces -Z: 10 pixels are about 1 m at z = 0. */
class Surface extends EventTarget implements InputSurface {
  getBoundingClientRect() {
    return { left: 0, top: 0, width: 100, height: 100 };
  }
  send(type: string, x: number, y = 50, more: Record<string, unknown> = {}): void {
    const event = new Event(type, { cancelable: true });
    const init = { clientX: x, clientY: y, pointerId: 1, pointerType: 'mouse', button: 0, buttons: 1 };
    this.dispatchEvent(Object.assign(event, init, more));
  }
}

let scene: Scene;
let surface: Surface;
let lamp: GameObject;

function box(name: string, x: number, parent?: GameObject): GameObject {
  const object = new GameObject(name);
  object.addComponent(ObjectRenderer, { mesh: 'box' });
  object.transform.position = [x, 0, 0];
  if (parent) parent.add(object);
  else scene.add(object);
  return object;
}

const noterOf = (object: GameObject): Noter => object.getComponent(Noter)!;

/** Simulates a frame: updates, and brings world matrices up to date. */
function frame(): void {
  scene.update(0.01);
  scene.three.updateMatrixWorld();
}

beforeEach(() => {
  calls.length = 0;
  scene = new Scene();
  surface = new Surface();
  new InputRouter(surface, null, {
    dispatchPointer: (event) => scene.dispatchPointer(event),
    dispatchKey: () => {},
  });
  const eye = new GameObject('Eye');
  eye.addComponent(Camera, { fov: Math.atan(0.5) * 2 });
  eye.transform.position = [0, 0, 10];
  scene.add(eye);
  scene.activeCamera!.setViewport(100, 100);
  // a lamp without a mesh of its own, with children foot and shade
  lamp = new GameObject('Lamp');
  lamp.addComponent(Noter);
  scene.add(lamp);
  box('Foot', -0.75, lamp);
  box('Shade', 0.75, lamp).addComponent(Noter);
  frame();
});

test('over and out come once, to the object and those above it, and to none for going from part to part', () => {
  surface.send('pointermove', 40);
  expect(calls).toEqual([]);
  frame();
  expect(calls.splice(0)).toEqual(['over Lamp']);
  surface.send('pointermove', 60);
  surface.send('pointermove', 61);
  frame();
  expect(calls.splice(0)).toEqual(['over Shade']);
  expect(noterOf(lamp.find('Shade')!).last!.target).toBe(lamp.find('Shade'));
  expect(noterOf(lamp.find('Shade')!).last!.point.z).toBeCloseTo(0.5, 6);
  expect(noterOf(lamp.find('Shade')!).last!.distance).toBeGreaterThan(9.5);
  surface.send('pointermove', 90);
  frame();
  expect(calls.splice(0)).toEqual(['out Shade', 'out Lamp']);
  surface.send('pointermove', 60);
  frame();
  calls.length = 0;
  surface.send('pointerleave', 60);
  expect(calls).toEqual(['out Shade', 'out Lamp']);
});

test('what moves away from under a pointer at rest, or comes under it, is told within eight frames', () => {
  surface.send('pointermove', 60);
  frame();
  expect(calls.splice(0)).toEqual(['over Shade', 'over Lamp']);
  lamp.transform.position = [20, 0, 0];
  for (let i = 0; i < 8; i++) frame();
  expect(calls.splice(0)).toEqual(['out Shade', 'out Lamp']);
  lamp.transform.position = [0, 0, 0];
  for (let i = 0; i < 8; i++) frame();
  expect(calls.splice(0)).toEqual(['over Shade', 'over Lamp']);
});

test('a click is a press and a release over one object; of two parts it is the object that holds both', () => {
  surface.send('pointerdown', 60);
  surface.send('pointerup', 62);
  expect(calls.splice(0)).toEqual([
    ...['over Shade', 'over Lamp', 'press Shade', 'press Lamp'],
    ...['release Shade', 'release Lamp', 'click Shade', 'click Lamp'],
  ]);
  surface.send('pointerdown', 54, 50);
  surface.send('pointerup', 46, 50);
  expect(calls.splice(0).slice(2)).toEqual(['out Shade', 'release Lamp', 'click Lamp']);
  // released too far from the press, then another button
  surface.send('pointerdown', 53.5, 45.5);
  surface.send('pointerup', 62, 55);
  surface.send('pointerdown', 60, 50, { button: 2 });
  surface.send('pointerup', 60, 50, { button: 2 });
  expect(calls.filter((call) => call.startsWith('click'))).toEqual([]);
});

test('a finger is over what it presses until it is lifted; what is cancelled is no click', () => {
  const finger = { pointerType: 'touch', pointerId: 7 };
  surface.send('pointerdown', 40, 50, finger);
  surface.send('pointerup', 40, 50, finger);
  surface.send('pointerleave', 40, 50, finger);
  expect(calls.splice(0)).toEqual(['over Lamp', 'press Lamp', 'release Lamp', 'click Lamp', 'out Lamp']);
  surface.send('pointerdown', 40, 50, finger);
  surface.send('pointercancel', 40, 50, finger);
  expect(calls.filter((call) => call.startsWith('click'))).toEqual([]);
  expect(calls).toContain('out Lamp');
});

test('stopPropagation keeps an event from the objects above; what is nearer hides what is behind', () => {
  noterOf(lamp.find('Shade')!).stops = true;
  surface.send('pointerdown', 60);
  expect(calls.splice(0)).toEqual(['over Shade', 'press Shade']);
  const wall = box('Wall', 0);
  wall.transform.position = [0, 0, 3];
  wall.transform.scale = [6, 6, 1];
  frame();
  surface.send('pointerdown', 60, 50, { pointerId: 2 });
  expect(calls).toEqual([]);
});

test('no ray is cast while nobody wants it, and what is switched off hears nothing', () => {
  let rays = 0;
  const shade = lamp.find('Shade')!.object3D.children[0];
  const { raycast } = shade;
  shade.raycast = (...args) => {
    rays++;
    raycast.apply(shade, args);
  };
  noterOf(lamp).listensTo = () => false;
  noterOf(lamp.find('Shade')!).enabled = false;
  surface.send('pointermove', 60);
  frame();
  surface.send('pointerdown', 60);
  expect([rays, calls]).toEqual([0, []]);
  noterOf(lamp).listensTo = (kind) => kind === 'pointer';
  surface.send('pointermove', 60);
  surface.send('pointermove', 61);
  frame();
  frame();
  expect([rays, calls]).toEqual([1, ['over Lamp']]);
});

test('it is seen through the camera that is said; what leaves the scene is let go of, and a reset forgets', () => {
  const other = scene.activeCamera!.three.clone();
  other.position.set(20, 0, 0);
  other.updateMatrixWorld();
  scene.pointerCamera = other;
  surface.send('pointerdown', 60);
  expect(calls).toEqual([]);
  scene.pointerCamera = null;
  surface.send('pointerdown', 60);
  calls.length = 0;
  lamp.find('Shade')!.dispose();
  surface.send('pointermove', 90);
  frame();
  expect(calls.splice(0)).toEqual(['out Lamp']);
  surface.send('pointermove', 40);
  frame();
  scene.reset();
  calls.length = 0;
  surface.send('pointermove', 90);
  frame();
  expect(calls).toEqual([]);
});

test('what a component throws in an event is told, and the others are called', () => {
  const errors: string[] = [];
  const keys = { type: 'down', code: 'KeyE', key: 'e', repeat: false } as EngineKeyEvent;
  noterOf(lamp.find('Shade')!).throws = true;
  expect(() => scene.dispatchKey(keys)).toThrow('key failed');
  scene.onComponentError = ({ gameObject }, error) => errors.push(`${gameObject.name}: ${(error as Error).message}`);
  calls.length = 0;
  scene.dispatchKey(keys);
  expect(calls.splice(0)).toHaveLength(2);
  surface.send('pointerdown', 60);
  expect(calls).toEqual(['over Shade', 'over Lamp', 'press Shade', 'press Lamp']);
  expect(errors).toEqual(['Shade: key failed', 'Shade: over failed', 'Shade: press failed']);
});
