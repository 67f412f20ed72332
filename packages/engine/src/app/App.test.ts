import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import type { WebGLRenderer } from 'three';
import { Camera } from '../components/Camera';
import { Component } from '../core/Component';
import type { EngineKeyEvent, EnginePointerEvent } from '../core/events';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { App } from './App';

const drawn: unknown[][] = [];

vi.mock('@farol/renderer', () => ({
  FarolRenderer: class {
    readonly info = { technique: '', passes: [] };
    readonly effects = [];
    readonly techniques = {};
    readonly ready = Promise.resolve();
    addEventListener(): void {}
    removeEventListener(): void {}
    render(...args: unknown[]): void {
      drawn.push(args);
    }
    dispose(): void {
      drawn.push(['disposed']);
    }
  },
}));

class FakeCanvas extends EventTarget {
  readonly style = {};
  readonly captured: number[] = [];
  getBoundingClientRect(): { left: number; top: number; width: number; height: number } {
    return { left: 10, top: 20, width: 200, height: 100 };
  }
  setPointerCapture(id: number): void {
    this.captured.push(id);
  }
}

class Ear extends Component {
  static override readonly typeName: string = 'Ear';
  readonly heard: (EnginePointerEvent | EngineKeyEvent)[] = [];
  override onPointerDown(event: EnginePointerEvent): void {
    this.heard.push(event);
  }
  override onPointerMove(event: EnginePointerEvent): void {
    this.heard.push(event);
  }
  override onPointerUp(event: EnginePointerEvent): void {
    this.heard.push(event);
  }
  override onPointerWheel(event: EnginePointerEvent): void {
    this.heard.push(event);
  }
  override onKeyDown(event: EngineKeyEvent): void {
    this.heard.push(event);
  }
  override onKeyUp(event: EngineKeyEvent): void {
    this.heard.push(event);
  }
}

class Clock extends Component {
  static override readonly typeName: string = 'Clock';
  readonly deltas: number[] = [];
  override update(delta: number): void {
    this.deltas.push(delta);
  }
}

const send = (target: EventTarget, type: string, values: Record<string, unknown> = {}): Event => {
  const event = new Event(type, { cancelable: true });
  for (const [name, value] of Object.entries(values)) Object.defineProperty(event, name, { value });
  target.dispatchEvent(event);
  return event;
};

let canvas: FakeCanvas;
let keys: EventTarget;
let app: App;
let ear: Ear;
let clock: Clock;
let frames: FrameRequestCallback[];

beforeEach(() => {
  drawn.length = 0;
  frames = [];
  vi.stubGlobal('requestAnimationFrame', (callback: FrameRequestCallback) => frames.push(callback));
  vi.stubGlobal('cancelAnimationFrame', () => (frames = []));
  canvas = new FakeCanvas();
  keys = new EventTarget();
  const scene = new Scene();
  const camera = new GameObject('Camera');
  camera.addComponent(Camera);
  ear = camera.addComponent(Ear);
  clock = camera.addComponent(Clock);
  scene.add(camera);
  const webgl = {
    domElement: canvas,
    clear: vi.fn<() => void>(),
    setSize: vi.fn<() => void>(),
    setPixelRatio: vi.fn<() => void>(),
    dispose: vi.fn<() => void>(),
  };
  app = new App({ webgl: webgl as unknown as WebGLRenderer, scene, keys });
});

afterEach(() => {
  app.dispose();
  vi.unstubAllGlobals();
});

/** Runs the callbacks of an animation frame at a time (ms). */
const display = (time: number): void => {
  const due = frames;
  frames = [];
  for (const callback of due) callback(time);
};

/** Resolves after all settled promises have called their handlers. */
const settled = (): Promise<string> => new Promise((resolve) => setImmediate(() => resolve('waits')));

describe('the loop', () => {
  test('updates and draws the scene by its camera in every frame, in steps of at most 0.1 s', () => {
    app.start();
    app.start();
    for (const time of [1000, 1016, 1032, 61_032, 61_000]) display(time);
    expect(clock.deltas.map((delta) => Math.round(delta * 1000))).toEqual([0, 16, 16, 100, 0]);
    expect(drawn).toHaveLength(5);
    expect(drawn[0]).toEqual([app.scene.three, app.scene.activeCamera!.three]);
  });

  test('draws on while the simulation pauses, and ends when it is stopped', () => {
    app.start();
    display(0);
    app.pause();
    display(16);
    app.play();
    display(32);
    app.stop();
    display(48);
    expect(drawn).toHaveLength(3);
    expect(clock.deltas).toEqual([0, 0.016]);
    expect(app.running).toBe(false);
  });

  test('tells listeners of each frame until they leave', () => {
    const times: number[] = [];
    const leave = app.onFrame(({ time }) => times.push(time));
    app.step(0.5);
    app.renderAt(4);
    leave();
    app.step(1);
    expect(times).toEqual([0.5, 4]);
  });

  test('renderAt draws exactly one frame at that time', () => {
    app.renderAt(7.5);
    expect(app.scene.time).toBe(7.5);
    expect(drawn).toHaveLength(1);
  });

  test('a scene without a camera is cleared, not drawn', () => {
    app.scene = new Scene();
    app.render();
    expect(drawn).toEqual([]);
    expect(app.webgl.clear).toHaveBeenCalledTimes(1);
  });

  test('the camera takes the aspect of the canvas, which is no edit', () => {
    const { revision } = app.scene;
    app.resize(300, 100, 2);
    app.render();
    const camera = app.scene.activeCamera!.three;
    expect(camera.projectionMatrix.elements[5] / camera.projectionMatrix.elements[0]).toBeCloseTo(3, 6);
    expect(app.webgl.setPixelRatio).toHaveBeenCalledWith(2);
    expect(app.scene.revision).toBe(revision);
  });
});

describe('ready', () => {
  test('draws by itself at rest, waits for the loop while that runs, and is rejected when the app goes', async () => {
    await app.ready;
    expect(drawn.length).toBeGreaterThan(0);
    drawn.length = 0;
    app.start();
    const ready = app.ready;
    await expect(Promise.race([ready, settled()])).resolves.toBe('waits');
    expect(drawn).toHaveLength(0);
    display(0);
    await ready;
    expect(drawn).toHaveLength(1);
    const asked = app.ready;
    app.dispose();
    await expect(asked).rejects.toThrow('disposed before it was ready');
  });
});

describe('input', () => {
  test('pointer events reach components in pixels of the canvas, with their motion', () => {
    send(canvas, 'pointerdown', { clientX: 60, clientY: 45, pointerId: 7, button: 0, buttons: 1 });
    send(canvas, 'pointermove', { clientX: 110, clientY: 40, pointerId: 7, button: -1, buttons: 1 });
    send(canvas, 'pointerup', { clientX: 110, clientY: 40, pointerId: 7, button: 0, buttons: 0 });
    expect(ear.heard.map(({ type }) => type)).toEqual(['down', 'move', 'up']);
    expect(ear.heard[0]).toMatchObject({ x: 50, y: 25, dx: 0, dy: 0, ndcX: -0.5, ndcY: 0.5, buttons: 1 });
    expect(ear.heard[1]).toMatchObject({ x: 100, y: 20, dx: 50, dy: -5, ndcX: 0, ndcY: 0.6 });
    expect(canvas.captured).toEqual([7]);
  });

  test('the wheel is in pixels, and does not scroll the page', () => {
    const event = send(canvas, 'wheel', { clientX: 0, clientY: 0, deltaY: 3, deltaMode: 1 });
    expect(ear.heard[0]).toMatchObject({ type: 'wheel', wheel: 48 });
    expect(event.defaultPrevented).toBe(true);
  });

  test('keys reach components; text fields keep theirs', () => {
    send(keys, 'keydown', { code: 'KeyW', key: 'w', shiftKey: true });
    send(keys, 'keydown', { code: 'KeyA', key: 'a', target: { tagName: 'INPUT' } });
    send(keys, 'keyup', { code: 'KeyA', key: 'a' });
    send(keys, 'keyup', { code: 'KeyW', key: 'w' });
    expect(ear.heard.map((event) => `${event.type} ${(event as EngineKeyEvent).code}`)).toEqual([
      'down KeyW',
      'up KeyW',
    ]);
    expect(ear.heard[0].shiftKey).toBe(true);
  });

  test('a text field within a shadow root keeps its keys', () => {
    const [host, field] = [{ tagName: 'MY-FIELD' }, { tagName: 'INPUT' }];
    send(keys, 'keydown', { code: 'KeyA', key: 'a', target: host, composedPath: () => [field, host] });
    expect(ear.heard).toEqual([]);
  });

  test('keys held while Command is down are let go with it: macOS tells of no other end', () => {
    send(keys, 'keydown', { code: 'MetaLeft', key: 'Meta' });
    send(keys, 'keydown', { code: 'KeyW', key: 'w', metaKey: true });
    send(keys, 'keydown', { code: 'KeyA', key: 'a', metaKey: true });
    send(keys, 'keyup', { code: 'MetaLeft', key: 'Meta' });
    expect(ear.heard.map((event) => `${event.type} ${(event as EngineKeyEvent).code}`)).toEqual([
      ...['down MetaLeft', 'down KeyW', 'down KeyA', 'up MetaLeft', 'up KeyW', 'up KeyA'],
    ]);
  });

  test('held keys are let go when the page loses focus, and when another scene comes', () => {
    send(keys, 'keydown', { code: 'KeyW' });
    send(keys, 'blur');
    send(keys, 'keydown', { code: 'KeyS' });
    app.scene = new Scene();
    expect(ear.heard.map(({ type }) => type)).toEqual(['down', 'up', 'down', 'up']);
  });

  test('components that are off, or whose object is not active, hear nothing', () => {
    ear.enabled = false;
    send(keys, 'keydown', { code: 'KeyW' });
    ear.enabled = true;
    ear.gameObject.active = false;
    send(canvas, 'pointerdown', { clientX: 0, clientY: 0, pointerId: 1 });
    expect(ear.heard).toEqual([]);
  });

  test('nothing is heard after dispose', () => {
    app.dispose();
    send(canvas, 'pointermove', { clientX: 0, clientY: 0, pointerId: 1 });
    send(keys, 'keydown', { code: 'KeyW' });
    expect(ear.heard).toEqual([]);
    expect(drawn.at(-1)).toEqual(['disposed']);
    expect(app.webgl.dispose).not.toHaveBeenCalled();
  });
});
